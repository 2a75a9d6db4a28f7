#include "engine/analysis/levels/levels.h"

#include <algorithm>
#include <numeric>

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

LevelBounds::LevelBounds(TaskGraph const &graph, Levels const &levels, LevelProfile const &from_inputs,
                         LevelProfile const &from_outputs)
    : graph_(graph),
      levels_(levels),
      span_(levels.span),
      work_(levels.work),
      due_(from_outputs.size() + 1),
      open_(from_inputs.size() + 1) {
  std::inclusive_scan(from_outputs.begin(), from_outputs.end(), due_.begin() + 1, std::plus<>(), Time{0});
  std::inclusive_scan(from_inputs.rbegin(), from_inputs.rend(), open_.begin() + 1, std::plus<>(), Time{0});
}

Time LevelBounds::simple_length(std::uint32_t units) const { return std::max(span_, shared(work_, units)); }

Time LevelBounds::length(std::uint32_t units) const {
  Time delay = 0;
  for (std::vector<Time> const *work : {&due_, &open_})
    for (std::size_t time = 1; time < work->size(); ++time)
      delay = std::max(delay, shared((*work)[time], units) - static_cast<Time>(time));
  return span_ + delay;
}

std::uint32_t LevelBounds::units(Time length) const {
  Time most = work_ == 0 ? 0 : std::max(surely_at_once(length), 1U);
  for (std::vector<Time> const *work : {&due_, &open_})
    for (std::size_t time = 1; time < work->size(); ++time)
      most = std::max(most, shared((*work)[time], static_cast<Time>(time) + length - span_));
  return static_cast<std::uint32_t>(most);
}

std::uint32_t LevelBounds::surely_at_once(Time length) const {
  LevelProfile counts(static_cast<std::size_t>(span_) + 1);
  for (TaskId task = 0; task < graph_.size(); ++task) {
    Time const begin = levels_.latest[task] + length - span_, end = levels_.earliest[task] + graph_.duration[task];
    if (begin >= end) continue;
    ++counts[static_cast<std::size_t>(begin)];
    --counts[static_cast<std::size_t>(end)];
  }
  for (std::size_t time = 1; time < counts.size(); ++time) counts[time] += counts[time - 1];
  return peak(counts);
}

} // namespace symreal
