#include "engine/analysis/tasks/stg.h"

#include <algorithm>
#include <ostream>

namespace symreal {
namespace {

std::vector<TaskId> without_successor(TaskGraph const &graph) {
  std::vector<char> has_successor(graph.size());
  for (TaskId before : graph.predecessor) has_successor[before] = 1;
  std::vector<TaskId> result;
  for (TaskId task = 0; task < graph.size(); ++task)
    if (!has_successor[task]) result.push_back(task);
  return result;
}

// Whether the graph has a single source and a single sink, both of zero duration.
bool has_dummies(TaskGraph const &graph, std::vector<TaskId> const &last) {
  auto const starts = [&](std::size_t task) { return graph.predecessors(static_cast<TaskId>(task)).empty(); };
  if (graph.size() < 2 || last.size() != 1 || last[0] + 1 != graph.size()) return false;
  for (std::size_t task = 1; task < graph.size(); ++task)
    if (starts(task)) return false;
  return graph.duration.front() == 0 && graph.duration.back() == 0;
}

void write_row(std::ostream &out, std::uint64_t id, Time duration, std::vector<std::uint64_t> const &before) {
  out << id << ' ' << duration << ' ' << before.size();
  for (std::uint64_t each : before) out << ' ' << each;
  out << '\n';
}

} // namespace

void write_stg(std::ostream &out, TaskGraph const &graph, std::vector<std::uint64_t> const &id) {
  std::vector<TaskId> const last = without_successor(graph);
  bool const add = !has_dummies(graph, last);
  out << (add ? graph.size() : graph.size() - 2) << '\n';
  if (add) write_row(out, 0, 0, {});
  auto const name = [&](TaskId task) { return !add && !id.empty() ? id[task] : task + std::uint64_t{add}; };
  std::vector<std::uint64_t> before;
  for (TaskId task = 0; task < graph.size(); ++task) {
    before.clear();
    for (TaskId other : graph.predecessors(task)) before.push_back(name(other));
    if (add && before.empty()) before.push_back(0);
    write_row(out, name(task), graph.duration[task], before);
  }
  if (!add) return;
  before.clear();
  for (TaskId task : last) before.push_back(name(task));
  if (before.empty()) before.push_back(0);
  write_row(out, graph.size() + 1, 0, before);
}

} // namespace symreal
