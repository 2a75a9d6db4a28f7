#include "engine/analysis/scheduling/insertion_scheduler.h"

#include <algorithm>

namespace symreal {

std::size_t Profile::step_at(Time at) {
  auto const next = std::ranges::upper_bound(steps_, at, {}, &Step::at);
  auto const step = next - 1;
  if (step->at == at) return static_cast<std::size_t>(step - steps_.begin());
  return static_cast<std::size_t>(steps_.insert(next, {at, step->busy}) - steps_.begin());
}

Time Profile::place(Time earliest, Time duration, unsigned units) {
  auto i = static_cast<std::size_t>(std::ranges::upper_bound(steps_, earliest, {}, &Step::at) - steps_.begin()) - 1;
  Time begin = earliest;
  for (; i < steps_.size() && steps_[i].at < begin + duration; ++i)
    if (steps_[i].busy >= units) begin = steps_[i + 1].at; // the last step is always free
  std::size_t const first = step_at(begin), end = step_at(begin + duration);
  for (std::size_t step = first; step < end; ++step) ++steps_[step].busy;
  return begin;
}

Time InsertionScheduler::run(std::span<Time const> priority, std::vector<Time> &start) {
  for (Profile &profile : busy_) profile.clear();
  start.assign(network_.size(), 0);
  Time end = 0;
  order_.for_each(network_, priority, [&](TaskId task) {
    Time earliest = 0;
    for (TaskId before : network_.before.of(task))
      earliest = std::max(earliest, start[before] + network_.duration[before]);
    std::size_t const kind = network_.kind[task];
    Time const duration = network_.duration[task];
    start[task] = duration == 0 ? earliest : busy_[kind].place(earliest, duration, units_.count[kind]);
    end = std::max(end, start[task] + duration);
  });
  return end;
}

} // namespace symreal
