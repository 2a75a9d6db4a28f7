#include "engine/graph/graph_text.h"
#include "tool/analysis/figures_report.h"
#include "tool/analysis/path_lines.h"

#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>

namespace symreal::tool {

namespace {

using Json = nlohmann::ordered_json;

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
