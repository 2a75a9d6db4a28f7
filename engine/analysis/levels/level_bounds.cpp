#include "engine/analysis/levels/level_bounds.h"

#include <algorithm>
#include <numeric>

namespace symreal {

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
