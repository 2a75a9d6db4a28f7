#include "tool/analysis/figures_report.h"

#include "tool/analysis/path_lines.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ostream.h>

namespace symreal::tool {

namespace {

void print_bounds(std::ostream &out, Costs const &costs, Figures const &figures) {
  fmt::print(out, "  shortest times    {:>14}{:>14}\n", "span or work", "by levels");
  for (LengthBound const &bound : figures.bounds)
    fmt::print(out, "  {:>7} unit{:<5} {:>14}{:>14}\n", bound.units, bound.units == 1 ? "" : "s",
               amount(costs, bound.simple), amount(costs, bound.by_levels));
}

// Prints the critical path; a long one is shown by its ends.
void print_path(std::ostream &out, Graph const &graph, Costs const &costs, Figures const &figures) {
  constexpr std::size_t most = 40;
  std::vector<PathLine> const lines = path_lines(graph, figures.critical_path);
  fmt::print(out, "  critical path: {} operations\n  {:>10}  {:<30} source\n", figures.critical_path.size(),
             "begins at", "operations");
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (lines.size() > most && k == most / 2) {
      fmt::print(out, "  {:>10}  {} further lines; --json has all\n", "...", lines.size() - most);
      k = lines.size() - most / 2;
    }
    PathLine const &line = lines[k];
    std::string where = line.place.file.empty() ? "" : fmt::format("{}:{}", line.place.file, line.place.line);
    if (!line.name.empty()) where += (where.empty() ? "" : " ") + fmt::format("'{}'", line.name);
    if (std::string const text = source_text(line.place); !text.empty()) where += ": " + text;
    std::string row = fmt::format("  {:>10}  {:<30} {}", amount(costs, line.start), to_string(line.operations), where);
    row.erase(row.find_last_not_of(' ') + 1);
    out << row << "\n";
  }
}

} // namespace

std::string amount(Costs const &costs, Time time) {
  return costs.scale == 1 ? std::to_string(time) : fmt::format("{:.1f}", costs.in_unit(time));
}

void print_figures(std::ostream &out, Graph const &graph, Costs const &costs, Figures const &figures) {
  Levels const &levels = figures.levels;
  fmt::print(out, "kernel {}: {} operations, costs: {}, times in {}\n", graph.kernel, figures.count, costs.name,
             costs.time_unit);
  fmt::print(out, "  {:<18}{:>14}\n", "work", amount(costs, levels.work));
  if (costs.scale != 1)
    fmt::print(out, "  {:<18}{:>14.1f}   if no operation had to wait\n", "throughput", figures.throughput_work);
  fmt::print(out, "  {:<18}{:>14}\n", "span", amount(costs, levels.span));
  fmt::print(out, "  {:<18}{:>14.2f}\n", "mean parallelism", levels.parallelism());
  fmt::print(out, "  {:<18}{:>14}   of {} operations; median {}, largest {}\n", "without slack", figures.slack.none,
             figures.count, amount(costs, figures.slack.median), amount(costs, figures.slack.largest));
  fmt::print(out, "  {:<18}{:>14}   from the inputs\n", "peak", peak(figures.from_inputs));
  fmt::print(out, "  {:<18}{:>14}   from the outputs\n", "", peak(figures.from_outputs));
  fmt::print(out, "  {:<18}{:>14}   levelled, in {}; at least {} for that length\n", "", figures.levelled.peak,
             amount(costs, figures.levelled.length), figures.least_units);
  print_bounds(out, costs, figures);
  print_path(out, graph, costs, figures);
}

} // namespace symreal::tool
