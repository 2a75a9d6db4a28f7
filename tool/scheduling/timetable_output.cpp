#include "tool/scheduling/timetable_output.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <nlohmann/json.hpp>
#include <numeric>
#include <tuple>

namespace symreal::tool {
namespace {

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
