#include "tool/analysis/timetable.h"

#include "engine/analysis/tasks/stg.h"
#include "engine/analysis/tasks/task_graph.h"
#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/graph_text.h"
#include "engine/support/files.h"
#include "tool/options/option_table.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>
#include <tuple>

namespace symreal::tool {
namespace {

// Does the first line other than comments begin the text of a graph?
bool is_graph(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size() && (text[at] == ';' || text[at] == '\n' || text[at] == '\r'))
    at = std::min(text.find('\n', at), text.size() - 1) + 1;
  return text.substr(at).starts_with("symreal-graph");
}

void read_recorded(TaskInput &input, std::string const &text, std::string const &cost) {
  require_one_of("--cost", cost, "unit|table");
  Graph const graph = read_graph(text, input.file);
  OperationTasks const read = operation_tasks(graph, cost == "table" ? table_costs() : unit_costs());
  input.tasks = read.tasks;
  std::vector<NodeId> const number = line_numbers(graph);
  for (NodeId node : read.node) {
    Op const op = graph.nodes[node].op;
    input.operation.push_back(op);
    input.name.push_back("%" + std::to_string(number[node]) + " " + std::string(info(op).name));
  }
}

constexpr unsigned most_units = 65'536;

unsigned read_count(std::string const &word) {
  unsigned count = 0;
  auto const [end, failed] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (word.empty() || failed != std::errc() || end != word.data() + word.size() || count > most_units)
    fail(DiagnosticId::bad_option, {},
         "--units takes a number up to " + std::to_string(most_units) + ", or kinds such as mul=2,other=1; not '" +
             word + "'");
  if (count == 0) fail(DiagnosticId::no_unit, {}, "0 units can run no task");
  return count;
}

// Group of an operation, by its syntactic form.
std::string_view group_of(Op op) {
  switch (info(op).form) {
  case Form::call:
  case Form::local: return "function";
  case Form::external: return "external";
  default: return "arithmetic";
  }
}

bool is_kind(std::string const &name) {
  return find_operation(name) || name == "arithmetic" || name == "function" || name == "external" || name == "other";
}

struct Kind {
  std::string name;
  unsigned count;
};

std::vector<Kind> read_kinds(std::string const &words) {
  std::vector<Kind> kinds;
  std::istringstream stream(words);
  for (std::string word; std::getline(stream, word, ',');) {
    std::size_t const equals = std::min(word.find('='), word.size());
    Kind kind{word.substr(0, equals), read_count(word.substr(std::min(equals + 1, word.size())))};
    if (!is_kind(kind.name))
      fail(DiagnosticId::bad_option, {},
           "--units: '" + kind.name + "' is neither an operation nor one of arithmetic, function, external, other");
    if (std::ranges::find(kinds, kind.name, &Kind::name) != kinds.end())
      fail(DiagnosticId::bad_option, {}, "--units lists '" + kind.name + "' twice");
    kinds.push_back(std::move(kind));
  }
  if (kinds.size() > 255) fail(DiagnosticId::bad_option, {}, "--units takes up to 255 kinds");
  return kinds;
}

void set_kinds(TaskInput &input, std::vector<Kind> const &kinds) {
  for (TaskId task = 0; task < input.tasks.size(); ++task) {
    Op const op = input.operation[task];
    auto found = kinds.end();
    for (std::string_view name : {info(op).name, group_of(op), std::string_view("other")})
      if (found == kinds.end()) found = std::ranges::find(kinds, name, &Kind::name);
    if (found == kinds.end())
      fail(DiagnosticId::no_unit, {input.file, 0, 0},
           "no unit runs '" + std::string(info(op).name) + "', which is of kind '" + std::string(group_of(op)) + "'");
    input.tasks.kind.push_back(static_cast<std::uint8_t>(found - kinds.begin()));
  }
}

constexpr std::size_t most_shown_units = 64;

std::vector<Time> busy_times(ScheduleReport const &report) {
  std::vector<Time> busy(report.units->name.size());
  for (TaskId task = 0; task < report.input->tasks.size(); ++task)
    busy[report.solution->timetable.unit[task]] += report.input->tasks.duration[task];
  return busy;
}

double percent(Time part, Time whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

double gap(Solution const &solution) { return percent(solution.length - solution.at_least, solution.at_least); }

std::vector<TaskId> in_order(ScheduleReport const &report) {
  Timetable const &table = report.solution->timetable;
  std::vector<TaskId> order(table.start.size());
  std::iota(order.begin(), order.end(), TaskId{0});
  std::ranges::sort(order, {}, [&](TaskId task) { return std::tuple(table.start[task], table.unit[task], task); });
  return order;
}

} // namespace

TaskInput read_tasks(std::string const &file, std::string const &cost) {
  TaskInput input{file, {}, {}, {}, {}};
  std::string const text = read_file(file);
  if (is_graph(text)) {
    read_recorded(input, text, cost.empty() ? "unit" : cost);
  } else {
    if (!cost.empty())
      fail(DiagnosticId::option_without_effect, {},
           "--cost is for recorded graphs, and '" + file + "' has processing times");
    StgTasks read = read_stg(text, file);
    input.tasks = std::move(read.tasks);
    input.id = std::move(read.id);
    for (std::uint64_t id : input.id) input.name.push_back(std::to_string(id));
  }
  return input;
}

NamedUnits read_units(std::string const &words, Time communication, TaskInput &input) {
  NamedUnits result{{{}, communication}, {}};
  if (words.find('=') == words.npos) {
    result.units.count = {read_count(words)};
    for (unsigned i = 0; i < result.units.count[0]; ++i) result.name.push_back("unit " + std::to_string(i));
    return result;
  }
  if (!input.is_recorded())
    fail(DiagnosticId::bad_option, {},
         "--units takes a number here: the tasks of '" + input.file + "' are of one kind");
  std::vector<Kind> const kinds = read_kinds(words);
  set_kinds(input, kinds);
  for (Kind const &kind : kinds) {
    result.units.count.push_back(kind.count);
    for (unsigned i = 0; i < kind.count; ++i) result.name.push_back(kind.name + " " + std::to_string(i));
  }
  if (result.name.size() > most_units)
    fail(DiagnosticId::bad_option, {}, "--units takes up to " + std::to_string(most_units) + " units");
  return result;
}

void print_summary(std::ostream &out, ScheduleReport const &report) {
  Solution const &solution = *report.solution;
  fmt::print(out, "tasks          {:>12}\nunits          {:>12}\nlength         {:>12}\n", report.input->tasks.size(),
             report.units->name.size(), solution.length);
  fmt::print(out, "at least       {:>12}   critical path {}, work {}, intervals {}\n", solution.at_least,
             solution.bounds.critical_path, solution.bounds.work, solution.bounds.interval);
  if (solution.is_optimal())
    fmt::print(out, "{:<15}{:>12}   proven optimal\n", "gap", 0);
  else
    fmt::print(out, "gap            {:>11.2f}%   not proven optimal\n", gap(solution));
  std::vector<Time> const busy = busy_times(report);
  for (std::size_t unit = 0; unit < std::min(busy.size(), most_shown_units); ++unit)
    fmt::print(out, "{:<15}{:>11.1f}% busy\n", report.units->name[unit], percent(busy[unit], solution.length));
  if (busy.size() > most_shown_units) fmt::print(out, "and {} more units\n", busy.size() - most_shown_units);
}

nlohmann::ordered_json summary_json(ScheduleReport const &report) {
  Solution const &solution = *report.solution;
  nlohmann::ordered_json units = nlohmann::ordered_json::array();
  std::vector<Time> const busy = busy_times(report);
  for (std::size_t unit = 0; unit < busy.size(); ++unit)
    units.push_back({{"name", report.units->name[unit]}, {"busy", busy[unit]}});
  return {{"tasks", report.input->tasks.size()},
          {"length", solution.length},
          {"bounds",
           {{"critical_path", solution.bounds.critical_path},
            {"work", solution.bounds.work},
            {"intervals", solution.bounds.interval},
            {"best", solution.at_least}}},
          {"gap_percent", gap(solution)},
          {"proven_optimal", solution.is_optimal()},
          {"communication", report.units->units.communication},
          {"units", units}};
}

void write_csv(std::ostream &out, ScheduleReport const &report) {
  Timetable const &table = report.solution->timetable;
  out << "task,unit,begin,end\n";
  for (TaskId task : in_order(report))
    out << report.input->name[task] << ',' << report.units->name[table.unit[task]] << ',' << table.start[task] << ','
        << table.start[task] + report.input->tasks.duration[task] << '\n';
}

nlohmann::ordered_json timetable_json(ScheduleReport const &report) {
  Timetable const &table = report.solution->timetable;
  nlohmann::ordered_json result = summary_json(report), rows = nlohmann::ordered_json::array();
  for (TaskId task : in_order(report))
    rows.push_back({{"task", report.input->name[task]},
                    {"unit", report.units->name[table.unit[task]]},
                    {"begin", table.start[task]},
                    {"end", table.start[task] + report.input->tasks.duration[task]}});
  result["timetable"] = std::move(rows);
  return result;
}

} // namespace symreal::tool
