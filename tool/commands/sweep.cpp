#include "tool/commands/sweep.h"

#include "engine/analysis/figures/growth.h"
#include "engine/graph/names.h"
#include "engine/graph/statistics.h"
#include "engine/support/number.h"
#include "rewrite/text/source_text.h"
#include "tool/calls/driver_program.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <nlohmann/json.hpp>

namespace symreal::tool {
namespace {

using Json = nlohmann::ordered_json;

// Names of the figures, in the order of sweep_member.
constexpr std::array<std::string_view, 7> names = {"operations",  "arithmetic",    "work", "span",
                                                   "parallelism", "critical_path", "peak"};

std::vector<Point> points(std::vector<SweepMember> const &members, std::size_t figure) {
  std::vector<Point> result;
  for (SweepMember const &member : members)
    result.push_back({static_cast<double>(member.size), member.figures[figure]});
  return result;
}

std::string percent(double residual) { return fmt::format("{:.2g} %", 100 * residual); }

std::string described(Polynomial const &polynomial, SweepSizes const &sizes) {
  std::string const text = to_string(polynomial, sizes.name);
  if (!polynomial.is_exact) return fmt::format("{}, residual {}", text, percent(polynomial.residual));
  bool const is_all = polynomial.from <= static_cast<double>(sizes.values.front());
  return text + (is_all ? ", exactly" : fmt::format(", exactly from {} = {} on", sizes.name, polynomial.from));
}

std::string cell(double figure) {
  return figure == std::floor(figure) ? fmt::format("{:.0f}", figure) : fmt::format("{:.2f}", figure);
}

Json to_json(Power const &power) {
  return {{"factor", power.factor}, {"exponent", power.exponent}, {"residual", power.residual}};
}

Json to_json(Polynomial const &polynomial) {
  return {{"coefficients", polynomial.coefficient},
          {"from", polynomial.from},
          {"exact", polynomial.is_exact},
          {"residual", polynomial.residual}};
}

[[noreturn]] void refuse_sizes(std::string const &text) {
  fail(DiagnosticId::bad_option, {},
       "--sweep takes NAME=FIRST..LAST, NAME=FIRST..LAST:STEP or NAME=VALUE,VALUE,..., not '" + text + "'");
}

long number(std::string_view word, std::string const &text) {
  long value = 0;
  auto const [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (failed != std::errc() || end != word.data() + word.size()) refuse_sizes(text);
  return value;
}

bool is_name(std::string_view word) {
  return !word.empty() && !std::isdigit(static_cast<unsigned char>(word[0])) &&
         std::ranges::all_of(word, rewrite::is_word);
}

// Interface that all members of a family share: objects by role, name and number of extents.
std::vector<std::string> interface_of(Graph const &graph) {
  std::vector<std::string> words;
  auto const add = [&](char const *role, std::vector<Object> const &objects) {
    for (Object const &object : objects)
      words.push_back(fmt::format("{} '{}'{}", role, identifier(object.label),
                                  object.extents.empty() ? "" : fmt::format(" of {} extents", object.extents.size())));
  };
  add("input", graph.inputs);
  add("parameter", graph.parameters);
  add("output", graph.outputs);
  return words;
}

class Family {
public:
  explicit Family(std::string name) : name_(std::move(name)) {}

  void require_member(long size, Graph const &graph) {
    std::vector<std::string> const words = interface_of(graph);
    if (kernel_.empty()) {
      kernel_ = graph.kernel;
      words_ = words;
      first_ = size;
    }
    if (graph.kernel != kernel_)
      refuse(size, fmt::format("kernel '{}'", kernel_), fmt::format("kernel '{}'", graph.kernel));
    for (std::size_t k = 0; k < std::max(words.size(), words_.size()); ++k) {
      std::string const before = k < words_.size() ? words_[k] : "no further object";
      std::string const now = k < words.size() ? words[k] : "no further object";
      if (before != now) refuse(size, before, now);
    }
  }

  [[noreturn]] void refuse(long size, std::string const &before, std::string const &now) const {
    fail(DiagnosticId::sweep_differs, {},
         fmt::format("with {0} = {1} the program has {2}, with {0} = {3} {4}", name_, first_, before, size, now));
  }

private:
  std::string name_, kernel_;
  std::vector<std::string> words_;
  long first_ = 0;
};

Graph single_graph(program::Front &front, SweepSizes const &sizes, long size) {
  if (front.kernels.size() != 1)
    fail(DiagnosticId::sweep_differs, {},
         fmt::format("with {} = {} the program has {} kernels: choose one with --kernel", sizes.name, size,
                     front.kernels.size()));
  return std::move(front.kernels.front().graph);
}

// Records one size; rewrites and builds the program only if the size changes it.
bool record_size(program::FrontRequest request, SweepRequest const &sweep, long size, program::Talk const &talk,
                 program::Front &front) {
  if (sweep.as_argument) request.run.arguments.push_back(std::to_string(size));
  bool const is_built = sweep.as_argument && front.workspace;
  if (!is_built) {
    front = {};
    if (!program::rewrite_sources(request, front, talk) || !program::build_programs(request, front, talk)) return false;
  }
  return program::record_kernels(request, front, talk);
}

} // namespace

SweepSizes parse_sweep(std::string const &text) {
  constexpr std::size_t most = 1000;
  std::size_t const equals = std::min(text.find('='), text.size() - 1);
  SweepSizes result{text.substr(0, equals), {}};
  if (!is_name(result.name)) refuse_sizes(text);
  std::string_view rest = std::string_view(text).substr(equals + 1);
  if (std::size_t const dots = rest.find(".."); dots != rest.npos) {
    std::size_t const colon = rest.find(':');
    long const first = number(rest.substr(0, dots), text);
    long const last = number(rest.substr(dots + 2, colon == rest.npos ? colon : colon - dots - 2), text);
    long const step = colon == rest.npos ? 1 : number(rest.substr(colon + 1), text);
    if (step < 1 || last < first || last - first > (1L << 32)) refuse_sizes(text);
    for (long value = first; value <= last && result.values.size() <= most; value += step)
      result.values.push_back(value);
  } else {
    for (std::size_t end = 0; end != rest.npos; rest.remove_prefix(std::min(end, rest.size() - 1) + 1)) {
      end = rest.find(',');
      result.values.push_back(number(rest.substr(0, end), text));
    }
    std::ranges::sort(result.values);
  }
  if (std::ranges::adjacent_find(result.values) != result.values.end()) refuse_sizes(text);
  if (result.values.size() < 2) fail(DiagnosticId::bad_option, {}, "--sweep needs two sizes at least: '" + text + "'");
  if (result.values.size() > most)
    fail(DiagnosticId::bad_option, {}, fmt::format("--sweep records each size: more than {} are too many", most));
  return result;
}

bool record_sweep(SweepRequest const &request, Console &console, std::function<void(long size, Graph)> const &take) {
  Family family(request.sizes.name);
  program::Front front;
  for (long const size : request.sizes.values) {
    std::vector<std::string> flags;
    if (!request.as_argument) flags.push_back(fmt::format("-D{}={}", request.sizes.name, size));
    bool is_recorded = false;
    with_driver(request.front(flags), request.calls, console.talk(), console,
                [&](program::FrontRequest const &called, program::Talk const &talk) {
                  is_recorded = record_size(called, request, size, talk, front);
                });
    if (!is_recorded) return false;
    Graph graph = single_graph(front, request.sizes, size);
    family.require_member(size, graph);
    take(size, std::move(graph));
  }
  return true;
}

SweepMember sweep_member(long size, Graph const &graph, Costs const &costs, Figures const &figures) {
  return {size,
          {static_cast<double>(figures.count), static_cast<double>(statistics(graph).compute.arithmetic()),
           costs.in_unit(figures.levels.work), costs.in_unit(figures.levels.span), figures.levels.parallelism(),
           static_cast<double>(figures.critical_path.size()), static_cast<double>(figures.levelled.peak)}};
}

void print_sweep(std::ostream &out, std::string const &kernel, SweepSizes const &sizes, Costs const &costs,
                 std::vector<SweepMember> const &members) {
  fmt::print(out, "kernel {}: costs: {}, times in {}\n{:>8}", kernel, costs.name, costs.time_unit, sizes.name);
  for (std::string_view name : names) fmt::print(out, "{:>15}", name);
  out << "\n";
  for (SweepMember const &member : members) {
    fmt::print(out, "{:>8}", member.size);
    for (double figure : member.figures) fmt::print(out, "{:>15}", cell(figure));
    out << "\n";
  }
  out << "growth\n";
  for (std::size_t figure = 0; figure < names.size(); ++figure) {
    std::vector<Point> const all = points(members, figure);
    auto const power = fit_power(all);
    auto const polynomial = fit_polynomial(all);
    std::string row = fmt::format("  {:<15}", names[figure]);
    if (power) row += fmt::format("{:<36}", to_string(*power, sizes.name) + ", residual " + percent(power->residual));
    if (polynomial) row += fmt::format("{}{}", power ? "  " : "", described(*polynomial, sizes));
    row.erase(row.find_last_not_of(' ') + 1);
    out << row << "\n";
  }
}

Json to_json(std::string const &kernel, SweepSizes const &sizes, Costs const &costs,
             std::vector<SweepMember> const &members) {
  Json json = {{"kernel", kernel}, {"costs", costs.name}, {"time_unit", costs.time_unit}, {"size", sizes.name}};
  for (SweepMember const &member : members) {
    Json row = {{"size", member.size}};
    for (std::size_t k = 0; k < names.size(); ++k) row[std::string(names[k])] = member.figures[k];
    json["members"].push_back(std::move(row));
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    Json growth = Json::object();
    if (auto const power = fit_power(points(members, k))) growth["power"] = to_json(*power);
    if (auto const polynomial = fit_polynomial(points(members, k))) growth["polynomial"] = to_json(*polynomial);
    json["growth"][std::string(names[k])] = std::move(growth);
  }
  return json;
}

std::string sweep_csv(SweepSizes const &sizes, std::vector<SweepMember> const &members) {
  std::string text = sizes.name;
  for (std::string_view name : names) text += "," + std::string(name);
  text += "\n";
  for (SweepMember const &member : members) {
    text += std::to_string(member.size);
    for (double figure : member.figures) text += "," + shortest(figure);
    text += "\n";
  }
  return text;
}

} // namespace symreal::tool
