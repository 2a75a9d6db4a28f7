#include "tool/analysis/figures_report.h"

#include "engine/analysis/figures/figures.h"
#include "engine/graph/graph.h"
#include "engine/graph/graph_text.h"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace symreal::tool {
namespace {

using Json = nlohmann::ordered_json;

// Critical path by source line: consecutive operations of one line form one entry.
struct PathLine {
  Place place;      // empty file: the graph has no places
  std::string name; // source name of the last of its values; may be empty
  Time start = 0, duration = 0;
  OperationCounts operations;
};

std::vector<PathLine> path_lines(Graph const &graph, std::vector<PathStep> const &path) {
  std::vector<PathLine> lines;
  NodeId last = no_node;
  for (PathStep const &step : path) {
    Place const place = place_of(graph, step.node);
    // Without places, runs of one operation form an entry.
    bool const is_other = place.file.empty() && last != no_node && graph.nodes[last].op != graph.nodes[step.node].op;
    last = step.node;
    if (lines.empty() || lines.back().place.file != place.file || lines.back().place.line != place.line || is_other) {
      lines.emplace_back();
      lines.back().place = place;
      lines.back().start = step.start;
    }
    PathLine &line = lines.back();
    if (step.node < graph.node_name.size() && graph.node_name[step.node] != no_name)
      line.name = graph.names[graph.node_name[step.node]];
    line.duration += step.duration;
    ++line.operations[graph.nodes[step.node].op];
  }
  return lines;
}

// Text such as "2 mul, add".
std::string to_string(OperationCounts const &counts) {
  std::string text;
  for (OperationInfo const &row : operations())
    if (std::size_t const count = counts[row.op])
      text += (text.empty() ? "" : ", ") + (count == 1 ? "" : std::to_string(count) + " ") + std::string(row.name);
  return text;
}

// Source line without its indentation; empty if it cannot be read.
std::string source_text(Place const &place) {
  constexpr std::size_t longest = 80;
  std::ifstream file(place.file);
  std::string text;
  for (unsigned line = 0; line < place.line; ++line)
    if (!std::getline(file, text)) return {};
  std::size_t const first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t\r");
  if (first == text.npos) return {};
  text = text.substr(first, last + 1 - first);
  return text.size() > longest ? text.substr(0, longest) + " ..." : text;
}

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

// Amount as JSON; unit costs stay integers.
Json json_amount(Costs const &costs, Time time) { return costs.scale == 1 ? Json(time) : Json(costs.in_unit(time)); }

Json path_to_json(Graph const &graph, Costs const &costs, Figures const &figures) {
  Json json = Json::array();
  for (PathLine const &line : path_lines(graph, figures.critical_path)) {
    Json entry = {{"begins", json_amount(costs, line.start)}, {"takes", json_amount(costs, line.duration)}};
    if (!line.place.file.empty()) entry.update({{"file", line.place.file}, {"line", line.place.line}});
    if (!line.name.empty()) entry["name"] = line.name;
    for (OperationInfo const &row : operations())
      if (std::size_t const count = line.operations[row.op]) entry["operations"][std::string(row.name)] = count;
    json.push_back(std::move(entry));
  }
  return json;
}

std::uint32_t at(LevelProfile const &profile, std::size_t time) { return time < profile.size() ? profile[time] : 0; }

} // namespace

std::string amount(Costs const &costs, Time time) {
  return costs.scale == 1 ? std::to_string(time) : fmt::format("{:.1f}", costs.in_unit(time));
}

std::string time_text(double nanoseconds) {
  if (nanoseconds < 1e3) return fmt::format("{:.0f} ns", nanoseconds);
  if (nanoseconds < 1e6) return fmt::format("{:.3g} us", nanoseconds / 1e3);
  return fmt::format("{:.3g} ms", nanoseconds / 1e6);
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

Json to_json(Graph const &graph, Costs const &costs, Figures const &figures) {
  Levels const &levels = figures.levels;
  Json json = {{"kernel", graph.kernel},
               {"costs", costs.name},
               {"time_unit", costs.time_unit},
               {"operations", figures.count},
               {"work", json_amount(costs, levels.work)},
               {"throughput_work", figures.throughput_work},
               {"span", json_amount(costs, levels.span)},
               {"parallelism", levels.parallelism()},
               {"slack",
                {{"none", figures.slack.none},
                 {"median", json_amount(costs, figures.slack.median)},
                 {"largest", json_amount(costs, figures.slack.largest)}}},
               {"peak",
                {{"from_inputs", peak(figures.from_inputs)},
                 {"from_outputs", peak(figures.from_outputs)},
                 {"levelled", figures.levelled.peak}}},
               {"levelled_length", json_amount(costs, figures.levelled.length)},
               {"least_units", figures.least_units},
               {"shortest", Json::array()}};
  for (LengthBound const &bound : figures.bounds)
    json["shortest"].push_back({{"units", bound.units},
                                {"span_or_work", json_amount(costs, bound.simple)},
                                {"by_levels", json_amount(costs, bound.by_levels)}});
  json["critical_path"] = path_to_json(graph, costs, figures);
  return json;
}

std::string profile_csv(Costs const &costs, Figures const &figures) {
  std::string text = "time,from_inputs,from_outputs,levelled\n";
  std::size_t const length = std::max(figures.from_inputs.size(), figures.evened.size());
  for (std::size_t time = 0; time < length; ++time)
    fmt::format_to(std::back_inserter(text), "{},{},{},{}\n", amount(costs, static_cast<Time>(time)),
                   at(figures.from_inputs, time), at(figures.from_outputs, time), at(figures.evened, time));
  return text;
}

std::string operations_csv(Graph const &graph, Costs const &costs, Figures const &figures) {
  std::string text = "node,operation,cost,earliest,latest,slack,levelled,file,line\n";
  std::vector<NodeId> const numbers = line_numbers(graph);
  for (TaskId task = 0; task < figures.operations.node.size(); ++task) {
    NodeId const node = figures.operations.node[task];
    Place const place = place_of(graph, node);
    fmt::format_to(std::back_inserter(text), "%{},{},{},{},{},{},{},{},{}\n", numbers[node],
                   info(graph.nodes[node].op).name, amount(costs, figures.operations.tasks.duration[task]),
                   amount(costs, figures.levels.earliest[task]), amount(costs, figures.levels.latest[task]),
                   amount(costs, figures.levels.slack(task)), amount(costs, figures.levelled.start[task]), place.file,
                   place.file.empty() ? "" : std::to_string(place.line));
  }
  return text;
}

} // namespace symreal::tool
