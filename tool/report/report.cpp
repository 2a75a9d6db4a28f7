#include "tool/report/report.h"

#include "engine/emit/language/words.h"
#include "engine/graph/graph.h"
#include "engine/graph/statistics.h"
#include "engine/support/number.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <map>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <vector>

namespace symreal::tool {
namespace {

using Json = nlohmann::ordered_json;

// Operations of a source line: where a kernel's work originates.
struct LineCount {
  Place place; // column 0
  std::size_t recorded = 0, generated = 0;
};

// Counts by line, most generated operations first. Empty if the graph has no places.
std::vector<LineCount> operations_by_line(RecordedCounts const &recorded, Graph const &optimised) {
  std::map<std::pair<std::string, unsigned>, LineCount> lines;
  std::vector<std::size_t> const generated = operations_by_location(optimised, true);
  for (std::size_t location = 0; location < optimised.locations.size(); ++location) {
    std::vector<Place> const &places = optimised.locations[location].places;
    std::size_t const before = recorded.by_location[location];
    if (places.empty() || (before == 0 && generated[location] == 0)) continue;
    LineCount &line = lines[{places.front().file, places.front().line}];
    line.recorded += before;
    line.generated += generated[location];
  }
  std::vector<LineCount> result;
  for (auto &[line, counts] : lines)
    result.push_back({{line.first, line.second, 0}, counts.recorded, counts.generated});
  std::stable_sort(result.begin(), result.end(),
                   [](LineCount const &a, LineCount const &b) { return a.generated > b.generated; });
  return result;
}

void print_lines(std::ostream &out, std::vector<LineCount> const &lines) {
  if (lines.empty()) return;
  constexpr std::size_t most = 20;
  fmt::print(out, "  operations by source line (recorded, generated)\n");
  std::size_t recorded = 0, generated = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (i < most)
      fmt::print(out, "    {:>12}{:>12}  {}:{}\n", lines[i].recorded, lines[i].generated, lines[i].place.file,
                 lines[i].place.line);
    else
      recorded += lines[i].recorded, generated += lines[i].generated;
  if (lines.size() > most)
    fmt::print(out, "    {:>12}{:>12}  on {} further lines\n", recorded, generated, lines.size() - most);
}

Json to_json(std::vector<LineCount> const &lines) {
  Json json = Json::array();
  for (LineCount const &line : lines)
    json.push_back({{"file", line.place.file},
                    {"line", line.place.line},
                    {"recorded", line.recorded},
                    {"generated", line.generated}});
  return json;
}

struct Column {
  std::string name;
  OperationCounts counts;
};

std::vector<Column> columns(KernelReport const &report) {
  Statistics const after = statistics(*report.graph);
  std::vector<Column> all = {{"executed", report.graph->executed},
                             {"recorded", report.recorded.operations},
                             {"compute", after.compute},
                             {"preprocess", after.preprocess}};
  if (report.looped) all.push_back({"with loops", *report.looped});
  return all;
}

void print_row(std::ostream &out, std::string const &name, std::vector<std::size_t> const &cells) {
  fmt::print(out, "  {:<16}", name);
  for (std::size_t cell : cells) fmt::print(out, "{:>12}", cell == 0 ? "." : std::to_string(cell));
  out << "\n";
}

void print_operations(std::ostream &out, std::vector<Column> const &table) {
  fmt::print(out, "  {:<16}", "operations");
  for (Column const &column : table) fmt::print(out, "{:>12}", column.name);
  out << "\n";
  std::vector<std::size_t> sums(table.size());
  for (OperationInfo const &operation : operations()) {
    std::vector<std::size_t> cells;
    bool any = false;
    for (std::size_t i = 0; i < table.size(); ++i) {
      cells.push_back(table[i].counts[operation.op]);
      any |= cells.back() != 0;
    }
    if (any) print_row(out, std::string(operation.name), cells);
  }
  for (std::size_t i = 0; i < table.size(); ++i) sums[i] = table[i].counts.arithmetic();
  print_row(out, "+ - * / together", sums);
}

std::string extents(Object const &object) {
  std::string text;
  for (std::size_t extent : object.extents) text += fmt::format("[{}]", extent);
  return text;
}

void print_objects(std::ostream &out, char const *role, std::vector<Object> const &objects) {
  for (Object const &object : objects)
    fmt::print(out, "  {:<10}{:>6}..{:<6}{}  {}\n", role, object.first, object.first + object.count - 1, object.label,
               extents(object));
}

// Warns if the operations are not fewer: then the original's vectorised loops may be faster.
void print_gain(std::ostream &out, Graph const &graph) {
  std::size_t const before = graph.executed.arithmetic(), after = statistics(graph).compute.arithmetic();
  if (after == 0 || 10 * after < 9 * before) return;
  fmt::print(
      out,
      "  the generated code has as many operations as the original ({} of {}): where a compiler makes vector code "
      "of the original's loops, the original may win; measure both, and --vector\n",
      after, before);
}

// Treatment of a decision, in words.
std::string became(program::DecidedPlace const &decision) {
  std::string text;
  for (auto const &[is_so, word] : {std::pair(decision.is_selected, "select"),
                                    {decision.is_joined, "join"},
                                    {decision.is_explored, "paths"},
                                    {decision.is_guarded, "guard"}})
    if (is_so) text += (text.empty() ? "" : " and ") + std::string(word);
  return text;
}

char const *completeness(program::Exploration const &exploration) {
  if (!exploration.is_complete()) return "not complete: see the guards";
  if (exploration.unmet != 0) return "complete for the paths that samples take: see the guards";
  if (exploration.guards == 0) return "complete: no guards";
  return exploration.zeros != 0 ? "complete but for exact zeros: see the guards"
                                : "complete but for the guards of pragmas and conversions";
}

void print_exploration(std::ostream &out, program::Exploration const &exploration) {
  fmt::print(out, "  explored       {} path{}, {} select{} between them; {}\n", exploration.paths,
             exploration.paths == 1 ? "" : "s", exploration.selects, exploration.selects == 1 ? "" : "s",
             completeness(exploration));
  if (exploration.joins != 0)
    fmt::print(out, "                 the ways from {} decision{} came together: {} pieces of a run, {} selects\n",
               exploration.joins, exploration.joins == 1 ? "" : "s", exploration.pieces, exploration.joined);
  if (exploration.samples != 0)
    fmt::print(out, "                 paths that {} given sample{} take{}; {} branch{} that none takes: a guard each\n",
               exploration.samples, exploration.samples == 1 ? "" : "s", exploration.samples == 1 ? "s" : "",
               exploration.unmet, exploration.unmet == 1 ? "" : "es");
  if (exploration.followed != 0)
    fmt::print(out, "                 {} decisions on these paths followed from earlier ones\n", exploration.followed);
  if (exploration.zeros != 0)
    fmt::print(out, "                 {} test{} for exact zero taken as not met\n", exploration.zeros,
               exploration.zeros == 1 ? "" : "s");
  if (exploration.by_range != 0)
    fmt::print(out, "                 {} condition{} beyond the range of an input taken as not met\n",
               exploration.by_range, exploration.by_range == 1 ? "" : "s");
  for (program::DecidedPlace const &one : exploration.places)
    fmt::print(out, "  decision        {}:{}:{}: {}\n", std::filesystem::path(one.place.file).filename().string(),
               one.place.line, one.place.column, became(one));
  if (exploration.cut_off + exploration.ended + exploration.late != 0)
    fmt::print(out, "                 {} cut off by the depth, {} ended by the program, {} not in time\n",
               exploration.cut_off, exploration.ended, exploration.late);
}

Json to_json(program::Exploration const &exploration) {
  Json json = {
      {"paths", exploration.paths},           {"selects", exploration.selects}, {"followed", exploration.followed},
      {"cut_off", exploration.cut_off},       {"ended", exploration.ended},     {"late", exploration.late},
      {"joins", exploration.joins},           {"pieces", exploration.pieces},   {"decided", exploration.decided},
      {"in_vain", exploration.in_vain},       {"zeros", exploration.zeros},     {"more_paths", exploration.paths_left},
      {"complete", exploration.is_complete()}};
  if (exploration.samples != 0) {
    json["samples"] = exploration.samples;
    json["unmet"] = exploration.unmet;
  }
  for (program::DecidedPlace const &one : exploration.places)
    json["decisions"].push_back({{"file", one.place.file},
                                 {"line", one.place.line},
                                 {"column", one.place.column},
                                 {"select", one.is_selected},
                                 {"join", one.is_joined},
                                 {"paths", one.is_explored},
                                 {"guard", one.is_guarded}});
  return json;
}

// Prints the guards, numbered as `compute` returns them.
void print_guards(std::ostream &out, Graph const &graph, bool details) {
  constexpr std::size_t most = 10;
  std::size_t const count = graph.guards.size(), shown = details ? count : std::min(count, most);
  for (std::size_t k = 0; k < shown; ++k)
    fmt::print(out, "  guard {:<9} {}\n", k + 1, guard_text(graph, graph.guards[k]));
  if (shown < count) fmt::print(out, "  ... {} guards in all; --stats lists them\n", count);
}

Json guards_to_json(Graph const &graph) {
  Json json = Json::array();
  for (Guard const &guard : graph.guards) {
    json.push_back({{"condition", guard.text}, {"places", Json::array()}});
    if (guard.location == no_location) continue;
    for (Place const &place : graph.locations[guard.location].places)
      json.back()["places"].push_back({{"file", place.file}, {"line", place.line}, {"column", place.column}});
  }
  return json;
}

Json to_json(OperationCounts const &counts) {
  Json json = Json::object();
  for (OperationInfo const &operation : operations())
    if (counts[operation.op] != 0) json[std::string(operation.name)] = counts[operation.op];
  json["arithmetic"] = counts.arithmetic();
  return json;
}

Json to_json(std::vector<Object> const &objects) {
  Json json = Json::array();
  for (Object const &object : objects)
    json.push_back(
        {{"label", object.label}, {"first", object.first}, {"count", object.count}, {"extents", object.extents}});
  return json;
}

} // namespace

RecordedCounts counts_of(Graph const &recorded) {
  return {statistics(recorded).recorded, operations_by_location(recorded, false)};
}

void print_table(std::ostream &out, KernelReport const &report, bool details) {
  Graph const &graph = *report.graph;
  fmt::print(out, "kernel {}: {} inputs, {} parameters, {} outputs, {} precomputed constants\n", graph.kernel,
             graph.input_count(), graph.parameter_count(), graph.output_count(), graph.precomputed.size());
  print_operations(out, columns(report));
  if (details) {
    out << "  live operations after each pass (+ - * /, functions)\n";
    for (Stage const &stage : report.stages)
      fmt::print(out, "    {:<14}{:>12}{:>12}\n", stage.name, stage.live.arithmetic(), stage.live.calls());
    print_objects(out, "input", graph.inputs);
    print_objects(out, "parameter", graph.parameters);
    print_objects(out, "output", graph.outputs);
    print_lines(out, operations_by_line(report.recorded, graph));
    print_gain(out, graph);
  }
  if (report.exploration) print_exploration(out, *report.exploration);
  print_guards(out, graph, details);
  for (Frozen const &state : graph.frozen)
    fmt::print(out, "  baked in        {} = {}  ({})\n", state.name, value_list(state.values), to_string(state.place));
  std::string times;
  for (auto const &[part, seconds] : report.seconds)
    times += fmt::format("{}{} {:.2f} s", times.empty() ? "" : ", ", part, seconds);
  if (!times.empty()) fmt::print(out, "  {}\n", times);
  for (std::string const &file : report.files) fmt::print(out, "  wrote {}\n", file);
}

Json to_json(KernelReport const &report) {
  Graph const &graph = *report.graph;
  Json json = {{"kernel", graph.kernel},
               {"inputs", to_json(graph.inputs)},
               {"parameters", to_json(graph.parameters)},
               {"outputs", to_json(graph.outputs)},
               {"constants", graph.precomputed.size()}};
  if (report.exploration) json["exploration"] = to_json(*report.exploration);
  if (!graph.guards.empty()) json["guards"] = guards_to_json(graph);
  for (Column const &column : columns(report)) json["operations"][column.name] = to_json(column.counts);
  json["passes"] = Json::array();
  for (Stage const &stage : report.stages)
    json["passes"].push_back({{"after", stage.name}, {"live", to_json(stage.live)}});
  if (auto lines = operations_by_line(report.recorded, graph); !lines.empty()) json["lines"] = to_json(lines);
  json["frozen"] = Json::array();
  for (Frozen const &state : graph.frozen)
    json["frozen"].push_back({{"name", state.name}, {"place", to_string(state.place)}, {"values", state.values}});
  for (auto const &[part, seconds] : report.seconds) json["seconds"][part] = seconds;
  json["files"] = report.files;
  return json;
}

} // namespace symreal::tool
