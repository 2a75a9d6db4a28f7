#include "tool/html/report_data.h"

#include "engine/emit/emit.h"
#include "engine/support/files.h"
#include "engine/support/installation.h"
#include "tool/analysis/figures_report.h"
#include "tool/html/graph_data.h"

#include <algorithm>
#include <set>

namespace symreal::tool {
namespace {

using Json = nlohmann::ordered_json;

Json thinned(LevelProfile const &profile, std::size_t step) {
  Json values = Json::array();
  for (std::size_t at = 0; at < profile.size(); at += step) {
    auto const first = profile.begin() + static_cast<std::ptrdiff_t>(at);
    values.push_back(
        *std::max_element(first, first + static_cast<std::ptrdiff_t>(std::min(step, profile.size() - at))));
  }
  return values;
}

// {"step": 1, "from_inputs": [...], "from_outputs": [...], "levelled": [...]}: maximum of each `step` units of time.
Json profile_data(Figures const &figures) {
  constexpr std::size_t most_points = 20'000;
  std::size_t const length = std::max(figures.from_inputs.size(), figures.evened.size());
  std::size_t const step = std::max((length + most_points - 1) / most_points, std::size_t{1});
  return {{"step", step},
          {"from_inputs", thinned(figures.from_inputs, step)},
          {"from_outputs", thinned(figures.from_outputs, step)},
          {"levelled", thinned(figures.evened, step)}};
}

// [{"name": "arm.cpp", "text": "...", "functions": [["dot", 3, 9], ...]}, ...]; null text: the file is missing.
Json source_data(Sources const &sources) {
  Json files = Json::array();
  for (SourceFile const &file : sources.files()) {
    Json functions = Json::array();
    for (FunctionLines const &function : file.functions)
      functions.push_back({function.name, function.first, function.last});
    files.push_back({{"name", file.name}, {"text", nullptr}, {"functions", std::move(functions)}});
    if (file.text) files.back()["text"] = *file.text;
  }
  return files;
}

// Distinct source lines of the locations, including inlined ones.
Json places(Graph const &graph, std::vector<LocationId> const &locations, Sources const &sources) {
  std::set<std::pair<std::size_t, unsigned>> lines;
  for (LocationId location : locations)
    for (Place const &place : graph.locations[location].places)
      if (auto const file = sources.number_of(place.file)) lines.emplace(*file, place.line);
  Json json = Json::array();
  for (auto const &[file, line] : lines) json.push_back({file, line});
  return json;
}

// {"name": "arm.c", "text": "...", "origins": [[first, last, [[file, line], ...]], ...]}; for long code: {"nodes": n}.
Json code_data(Graph const &graph, FloatingPoint mode, Sources const &sources) {
  constexpr std::size_t most_nodes = 100'000; // a larger page would be slow, and its code unread
  if (graph.nodes.size() > most_nodes) return {{"nodes", graph.nodes.size()}};
  Plan const plan = schedule(graph);
  EmitOptions options;
  options.base_name = graph.kernel;
  options.mode = mode;
  options.origins = true;
  EmittedFile const file = emit(plan, *find_language("c"), options).front();
  Json origins = Json::array();
  for (LineOrigin const &origin : file.origins)
    origins.push_back({origin.first_line, origin.last_line, places(graph, origin.locations, sources)});
  return {{"name", file.name}, {"text", file.text}, {"origins", std::move(origins)}};
}

// Timetable of `compute` on units, as by `schedule`.
Json timetable(Graph const &graph, OperationTasks const &operations, std::string const &units) {
  TaskInput input;
  input.tasks = operations.tasks;
  for (NodeId node : operations.node) input.operation.push_back(graph.nodes[node].op);
  NamedUnits const named = read_units(units, 0, input);
  Solution const solution = schedule_tasks(input.tasks, named.units, Effort());
  return timetable_data(graph, {&input, &named, &solution}, operations.node);
}

bool has_number(Json const &json, char const *key) { return json.contains(key) && json[key].is_number(); }

// Does the JSON have the members that the page reads?
bool is_verification(Json const &json) {
  if (!json.is_object() || !json.contains("kernel") || !json["kernel"].is_string() || !has_number(json, "samples") ||
      !has_number(json, "inside") || !json.contains("outputs") || !json["outputs"].is_array())
    return false;
  for (Json const &output : json["outputs"])
    if (!output.is_object() || !output.contains("label") || !has_number(output, "worst_ulp") ||
        !has_number(output, "different"))
      return false;
  for (Json const &guard : json.value("guards", Json::array()))
    if (!guard.is_object() || !has_number(guard, "failed")) return false;
  return true;
}

} // namespace

Json report_data(ReportRequest const &request, Sources const &sources) {
  Graph const &graph = *request.kernel.graph;
  Figures const all = figures(graph, request.costs, {});
  return {{"tool", version},
          {"mode", to_string(request.mode)},
          {"time_scale", request.costs.scale},
          {"kernel", to_json(request.kernel)},
          {"figures", to_json(graph, request.costs, all)},
          {"profiles", profile_data(all)},
          {"sources", source_data(sources)},
          {"code", code_data(graph, request.mode, sources)},
          {"graph", node_data(graph, all, sources)},
          {"timetable", timetable(graph, all.operations, request.units)},
          {"verification", request.verification}};
}

Json read_verification(std::string const &file, std::string const &kernel) {
  Json const read = Json::parse(read_file(file), nullptr, /*allow_exceptions=*/false);
  Json const all = read.is_object() && read.contains("kernels") ? read["kernels"] : Json::array({read});
  for (Json const &one : all) {
    if (!is_verification(one))
      fail(DiagnosticId::verification_file, {file}, "this file is not what verify --json prints");
    if (one["kernel"] == kernel) return one;
  }
  fail(DiagnosticId::verification_file, {file}, "this file has no verification of kernel '" + kernel + "'");
}

} // namespace symreal::tool
