#include "engine/analysis/scheduling/timetable.h"

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <numeric>
#include <queue>

namespace symreal {
namespace {

std::size_t kind_of(TaskGraph const &graph, TaskId task) { return graph.kind.empty() ? 0 : graph.kind[task]; }

std::vector<TaskId> by_start(TaskGraph const &graph, std::vector<Time> const &start) {
  std::vector<TaskId> order(graph.size());
  std::iota(order.begin(), order.end(), TaskId{0});
  std::ranges::stable_sort(order, {}, [&](TaskId task) { return start[task]; });
  return order;
}

std::string name(TaskId task) { return "task " + std::to_string(task); }

std::optional<std::string> fault_of_task(TaskGraph const &graph, Units const &units, Timetable const &timetable,
                                         std::vector<char> const &is_dummy, TaskId task) {
  std::uint32_t const unit = timetable.unit[task], first = units.first_of(kind_of(graph, task));
  if (timetable.start[task] < 0) return name(task) + " begins before time 0";
  if (unit < first || unit >= first + units.count[kind_of(graph, task)])
    return name(task) + " needs a unit of its kind";
  for (TaskId before : graph.predecessors(task)) {
    bool const moved = timetable.unit[before] != unit && !is_dummy[before] && !is_dummy[task];
    if (timetable.start[before] + graph.duration[before] + (moved ? units.communication : 0) > timetable.start[task])
      return name(task) + " begins before it has what " + name(before) + " computes";
  }
  return {};
}

} // namespace

unsigned Units::total() const { return std::accumulate(count.begin(), count.end(), 0u); }

unsigned Units::first_of(std::size_t kind) const {
  return std::accumulate(count.begin(), count.begin() + static_cast<std::ptrdiff_t>(kind), 0u);
}

Timetable assign_units(TaskGraph const &graph, Units const &units, std::vector<Time> const &start) {
  struct FreeUnit {
    Time from;
    std::uint32_t unit;
    auto operator<=>(FreeUnit const &) const = default;
  };
  // Per kind, a heap of units by the time at which they are free.
  std::vector<std::priority_queue<FreeUnit, std::vector<FreeUnit>, std::greater<>>> free(units.count.size());
  for (std::size_t kind = 0; kind < units.count.size(); ++kind)
    for (unsigned i = 0; i < units.count[kind]; ++i) free[kind].push({0, units.first_of(kind) + i});
  Timetable result{start, std::vector<std::uint32_t>(graph.size())};
  for (TaskId task : by_start(graph, start)) {
    auto &queue = free[kind_of(graph, task)];
    FreeUnit const next = queue.top();
    result.unit[task] = next.unit;
    if (graph.duration[task] == 0) continue;
    internal_check(next.from <= start[task]);
    queue.pop();
    queue.push({start[task] + graph.duration[task], next.unit});
  }
  return result;
}

std::vector<char> dummies(TaskGraph const &graph) {
  Successors const next = successors(graph);
  std::vector<char> result(graph.size());
  for (TaskId task = 0; task < graph.size(); ++task)
    result[task] = graph.duration[task] == 0 && (graph.predecessors(task).empty() || next.of(task).empty());
  return result;
}

std::optional<std::string> fault(TaskGraph const &graph, Units const &units, Timetable const &timetable) {
  if (timetable.start.size() != graph.size() || timetable.unit.size() != graph.size()) return "tasks are missing";
  std::vector<char> const is_dummy = dummies(graph);
  for (TaskId task = 0; task < graph.size(); ++task)
    if (auto wrong = fault_of_task(graph, units, timetable, is_dummy, task)) return wrong;
  std::vector<TaskId> last(units.total(), static_cast<TaskId>(graph.size()));
  for (TaskId task : by_start(graph, timetable.start)) {
    if (graph.duration[task] == 0) continue;
    TaskId &before = last[timetable.unit[task]];
    if (before != graph.size() && timetable.start[before] + graph.duration[before] > timetable.start[task])
      return name(before) + " and " + name(task) + " overlap on one unit";
    before = task;
  }
  return {};
}

} // namespace symreal
