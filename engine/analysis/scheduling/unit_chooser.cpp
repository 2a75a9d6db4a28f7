#include "engine/analysis/scheduling/unit_chooser.h"

#include <algorithm>

namespace symreal {

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
