#include "engine/analysis/scheduling/list_scheduler.h"

#include <algorithm>

namespace symreal {

void ListScheduler::make_ready(TaskId task) {
  if (network_.duration[task] == 0)
    instant_.push_back(task);
  else
    ready_[network_.kind[task]].push({priority_[task], task});
}

void ListScheduler::end_task(TaskId task) {
  for (TaskId after : network_.after.of(task))
    if (--waits_for_[after] == 0) make_ready(after);
  while (!instant_.empty()) {
    TaskId const next = instant_.back();
    instant_.pop_back();
    (*start_)[next] = now_;
    for (TaskId after : network_.after.of(next))
      if (--waits_for_[after] == 0) make_ready(after);
  }
}

Time ListScheduler::run(std::span<Time const> priority, std::vector<Time> &start) {
  priority_ = priority;
  start_ = &start;
  now_ = 0;
  start.assign(network_.size(), 0);
  ready_.resize(units_.count.size());
  waits_for_.resize(network_.size());
  std::vector<TaskId> first;
  for (TaskId task = 0; task < network_.size(); ++task) {
    waits_for_[task] = static_cast<std::uint32_t>(network_.before.of(task).size());
    if (waits_for_[task] == 0) first.push_back(task);
  }
  for (TaskId task : first) {
    if (network_.duration[task] == 0)
      end_task(task);
    else
      make_ready(task);
  }
  std::vector<unsigned> free = units_.count;
  while (true) {
    for (std::size_t kind = 0; kind < free.size(); ++kind)
      for (; free[kind] != 0 && !ready_[kind].empty(); --free[kind]) {
        TaskId const task = ready_[kind].top().task;
        ready_[kind].pop();
        start[task] = now_;
        running_.push({now_ + network_.duration[task], task});
      }
    if (running_.empty()) return now_;
    now_ = running_.top().at;
    while (!running_.empty() && running_.top().at == now_) {
      TaskId const task = running_.top().task;
      running_.pop();
      ++free[network_.kind[task]];
      end_task(task);
    }
  }
}

std::size_t Profile::step_at(Time at) {
  auto const next = std::ranges::upper_bound(steps_, at, {}, &Occupancy::at);
  auto const step = next - 1;
  if (step->at == at) return static_cast<std::size_t>(step - steps_.begin());
  return static_cast<std::size_t>(steps_.insert(next, {at, step->busy}) - steps_.begin());
}

Time Profile::place(Time earliest, Time duration, unsigned units) {
  auto i =
      static_cast<std::size_t>(std::ranges::upper_bound(steps_, earliest, {}, &Occupancy::at) - steps_.begin()) - 1;
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

void UnitChooser::find_data(TaskId task, Timetable const &result) {
  std::ranges::fill(data_, 0);
  for (TaskId before : network_.before.of(task)) {
    Time const end = result.start[before] + network_.duration[before];
    bool const is_free = is_dummy_[task] || is_dummy_[before];
    for (std::uint32_t unit = 0; unit < data_.size(); ++unit)
      data_[unit] = std::max(data_[unit], end + (is_free || unit == result.unit[before] ? 0 : units_.communication));
  }
}

UnitChooser::Gap UnitChooser::earliest_gap(std::uint32_t unit, TaskId task) const {
  std::vector<Busy> const &busy = busy_[unit];
  Time begin = data_[unit];
  auto i = static_cast<std::size_t>(std::ranges::upper_bound(busy, begin, {}, &Busy::until) - busy.begin());
  for (; i < busy.size() && busy[i].from < begin + network_.duration[task]; ++i) begin = std::max(begin, busy[i].until);
  return {begin, i};
}

void UnitChooser::place(TaskId task, std::vector<std::uint32_t> const *fixed, Timetable &result) {
  find_data(task, result);
  std::size_t const kind = network_.kind[task];
  std::uint32_t const first = fixed ? (*fixed)[task] : units_.first_of(kind);
  std::uint32_t const end = fixed || is_dummy_[task] ? first + 1 : first + units_.count[kind];
  std::uint32_t best_unit = first;
  bool const takes_time = network_.duration[task] != 0;
  Gap best = takes_time ? earliest_gap(first, task) : Gap{data_[first], 0};
  for (std::uint32_t unit = first + 1; unit < end; ++unit) {
    Gap const gap = takes_time ? earliest_gap(unit, task) : Gap{data_[unit], 0};
    // On ties the unit that has the data already wins, which leaves the others free.
    if (gap.begin > best.begin || (gap.begin == best.begin && data_[unit] >= data_[best_unit])) continue;
    best = gap;
    best_unit = unit;
  }
  result.start[task] = best.begin;
  result.unit[task] = best_unit;
  if (takes_time)
    busy_[best_unit].insert(busy_[best_unit].begin() + static_cast<std::ptrdiff_t>(best.before),
                            {best.begin, best.begin + network_.duration[task]});
}

Time UnitChooser::run(std::span<Time const> priority, std::vector<std::uint32_t> const *fixed, Timetable &result) {
  for (std::vector<Busy> &unit : busy_) unit.clear();
  result.start.assign(network_.size(), 0);
  result.unit.assign(network_.size(), 0);
  Time length = 0;
  order_.for_each(network_, priority, [&](TaskId task) {
    place(task, fixed, result);
    length = std::max(length, result.start[task] + network_.duration[task]);
  });
  return length;
}

} // namespace symreal
