#include "engine/analysis/levels/levels.h"

#include <algorithm>

namespace symreal {

Levels levels(TaskGraph const &graph) {
  Levels result;
  result.earliest.assign(graph.size(), 0);
  for (TaskId task = 0; task < graph.size(); ++task) {
    Time &start = result.earliest[task];
    for (TaskId before : graph.predecessors(task))
      start = std::max(start, result.earliest[before] + graph.duration[before]);
    result.span = std::max(result.span, start + graph.duration[task]);
    result.work += graph.duration[task];
  }
  // Holds latest ends first: a task must end before its users begin. Each is final when visited.
  result.latest.assign(graph.size(), result.span);
  for (TaskId task = static_cast<TaskId>(graph.size()); task-- > 0;) {
    Time &start = result.latest[task];
    start -= graph.duration[task];
    for (TaskId before : graph.predecessors(task)) result.latest[before] = std::min(result.latest[before], start);
  }
  return result;
}

std::vector<TaskId> critical_path(TaskGraph const &graph, Levels const &levels) {
  auto const end = [&](TaskId task) { return levels.earliest[task] + graph.duration[task]; };
  std::vector<TaskId> path;
  for (TaskId task = 0; task < graph.size() && path.empty(); ++task)
    if (end(task) == levels.span) path.push_back(task);
  while (!path.empty()) {
    std::span<TaskId const> const before = graph.predecessors(path.back());
    auto const next =
        std::ranges::find_if(before, [&](TaskId task) { return end(task) == levels.earliest[path.back()]; });
    if (next == before.end()) break;
    path.push_back(*next);
  }
  std::ranges::reverse(path);
  return path;
}

LevelProfile profile(TaskGraph const &graph, std::vector<Time> const &start, Time length) {
  // Differences may be negative in between, modulo 2^32.
  LevelProfile result(static_cast<std::size_t>(length) + 1);
  for (TaskId task = 0; task < graph.size(); ++task) {
    ++result[static_cast<std::size_t>(start[task])];
    --result[static_cast<std::size_t>(start[task] + graph.duration[task])];
  }
  for (std::size_t time = 1; time < result.size(); ++time) result[time] += result[time - 1];
  result.pop_back();
  return result;
}

std::uint32_t peak(LevelProfile const &profile) { return profile.empty() ? 0 : *std::ranges::max_element(profile); }

} // namespace symreal
