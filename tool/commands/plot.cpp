#include "engine/analysis/figures/figures.h"
#include "engine/support/files.h"
#include "engine/support/number.h"
#include "program/build/process.h"
#include "program/build/workspace.h"
#include "tool/commands/analyzed_graph.h"
#include "tool/commands/subcommands.h"
#include "tool/output/outputs.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <memory>
#include <string>

namespace symreal::tool {
namespace {

constexpr std::size_t most_steps = 2000; // exceeds the horizontal resolution of a plot

// Quotes a Gnuplot string: in single quotes only the quote is special, and is doubled.
std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (char const c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

std::string terminal(std::string const &image) {
  if (image.ends_with(".svg")) return "svg size 1500,420 dynamic noenhanced font 'Helvetica,13' background '#ffffff'";
  if (image.ends_with(".png")) return "pngcairo size 1500,420 noenhanced font 'Helvetica,10'";
  fail(DiagnosticId::bad_option, {}, "the ending of '" + image + "' names no image: use .svg or .png");
}

// Data of a plot; if there are too many steps, each point is the maximum of several.
std::string data(std::string const &name, Costs const &costs, LevelProfile const &profile) {
  std::size_t const width = (profile.size() + most_steps - 1) / most_steps;
  std::string text = "$" + name + " << END\n";
  for (std::size_t time = 0; time < profile.size(); time += width) {
    auto const first = profile.begin() + static_cast<std::ptrdiff_t>(time);
    auto const last = profile.begin() + static_cast<std::ptrdiff_t>(std::min(time + width, profile.size()));
    fmt::format_to(std::back_inserter(text), "{} {}\n", shortest(costs.in_unit(static_cast<Time>(time))),
                   *std::max_element(first, last));
  }
  return text + shortest(costs.in_unit(static_cast<Time>(profile.size()))) + " 0\nEND\n";
}

// Gnuplot script that writes `image`, as SVG or PNG by its extension: plots side by side of the operations under way if
// all begin early, late, or levelled. Throws bad_option for another extension.
std::string plot_script(Graph const &graph, Costs const &costs, Figures const &figures, std::string const &image) {
  struct Plot {
    std::string name, title;
    LevelProfile const &profile;
  } const plots[] = {{"inputs", "from the inputs", figures.from_inputs},
                     {"outputs", "from the outputs", figures.from_outputs},
                     {"levelled", "levelled", figures.evened}};
  std::string text = "set terminal " + terminal(image) + "\nset output " + in_quotes(image) + "\n";
  std::size_t length = 0;
  for (Plot const &plot : plots) {
    text += data(plot.name, costs, plot.profile);
    length = std::max(length, plot.profile.size());
  }
  std::uint32_t const highest = std::max(peak(figures.from_inputs), peak(figures.from_outputs));
  std::string const heading =
      fmt::format("{}: {} operations, span {} {}, mean parallelism {:.2f}", graph.kernel, figures.count,
                  shortest(costs.in_unit(figures.levels.span)), costs.time_unit, figures.levels.parallelism());
  text += fmt::format("set multiplot layout 1,3 title {}\n", in_quotes(heading));
  text += fmt::format("set xrange [0:{}]\nset yrange [0:{}]\n", shortest(costs.in_unit(static_cast<Time>(length))),
                      highest + std::max(highest / 20, 1U));
  text +=
      fmt::format("set xlabel {}\nset ylabel 'operations at once'\nunset key\n",
                  in_quotes(costs.scale == 1 ? "level (" + costs.time_unit + ")" : "time (" + costs.time_unit + ")"));
  for (Plot const &plot : plots)
    text += fmt::format("set title {}\nplot ${} using 1:2 with fillsteps fillstyle solid 1.0 linecolor rgb '#3b6ea5'\n",
                        in_quotes(fmt::format("{}, peak {}", plot.title, peak(plot.profile))), plot.name);
  return text + "unset multiplot\n";
}

struct Options {
  std::string file, output;
  AnalysisOptions analysis;
  PassOptions passes;
};

// Runs Gnuplot on the script, which writes `image`; returns the image.
std::string drawn(program::Workspace const &workspace, std::string const &script, std::string const &image) {
  std::string const file = workspace.file("plot.gp");
  write_if_changed(file, script);
  program::Captured const run = program::capture({{"gnuplot", file}});
  if (run.outcome.ending == program::Ending::not_started)
    fail(DiagnosticId::plotting_failed, {}, "'gnuplot' cannot be run");
  if (!run.outcome.success() || !std::filesystem::exists(image))
    fail(DiagnosticId::plotting_failed, {}, "'gnuplot' fails: " + run.output.substr(0, run.output.find('\n')));
  return read_file(image);
}

void run(Options const &options, CLI::App const &command) {
  Costs const costs = costs_named(options.analysis.cost);
  program::Workspace const workspace(/*keep=*/false);
  std::string const image = workspace.file("plot" + std::filesystem::path(options.output).extension().string());
  Graph const graph = analyzed_graph(command, options.passes, options.file);
  require_writable(options.output);
  std::string const script = plot_script(graph, costs, figures(graph, costs, options.analysis.goal(costs)), image);
  write_outputs({{{options.output, drawn(workspace, script, image)}}});
}

} // namespace

void add_plot(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("plot", "Plot how many operations of a graph run in parallel");
  auto options = std::make_shared<Options>();
  command->add_option("graph", options->file, "Graph text, as written by generate --graph")->required();
  command->add_option("-o", options->output, "Image, .svg or .png")->required()->type_name("FILE");
  options->analysis.add_to(*command);
  add_passes_before_analysis(*command, options->passes);
  command->callback([options, command, &session] {
    refuse_flags(session);
    run(*options, *command);
  });
}

} // namespace symreal::tool
