#include "engine/analysis/scheduling/improvement.h"

#include <algorithm>

namespace symreal {
namespace {

// Priorities by the tasks' ends: in the mirror image the last to end is the first to begin.
void set_ends(std::vector<Time> &priority, Network const &network, std::vector<Time> const &start) {
  priority.resize(network.size());
  for (TaskId task = 0; task < network.size(); ++task) priority[task] = start[task] + network.duration[task];
}

void mirror(std::vector<Time> &start, Network const &network, Time length) {
  for (TaskId task = 0; task < network.size(); ++task) start[task] = length - start[task] - network.duration[task];
}

std::vector<Time> with_duration(Network const &network, std::vector<Time> tail) {
  for (TaskId task = 0; task < network.size(); ++task) tail[task] += network.duration[task];
  return tail;
}

} // namespace

Improvement::Improvement(Network const &network, Units const &units, Time enough)
    : network_(network),
      enough_(enough),
      reversed_(reversed(network)),
      list_(network_, units),
      list_from_end_(reversed_, units),
      insertion_(network_, units),
      insertion_from_end_(reversed_, units) {}

void Improvement::keep(std::vector<Time> const &start, Time length) {
  if (!start_.empty() && length >= length_) return;
  start_ = start;
  length_ = length;
}

Time Improvement::justify(std::vector<Time> &start, Time length) {
  for (Time before = length + 1; length < before && length > enough_;) {
    before = length;
    set_ends(priority_, network_, start);
    insertion_from_end_.run(priority_, other_);
    set_ends(priority_, reversed_, other_);
    length = insertion_.run(priority_, start);
  }
  return length;
}

void Improvement::try_one_list() {
  std::vector<Time> start;
  Time const result = list_.run(with_duration(network_, longest_paths(reversed_)), start);
  keep(start, result);
}

void Improvement::try_lists(Windows const &windows) {
  try_one_list();
  if (is_enough()) return;
  std::vector<Time> start = start_;
  keep(start, justify(start, length_));
  for (bool const from_end : {false, true})
    for (bool const insert : {false, true}) {
      if (is_enough()) return;
      auto const priority = with_duration(network_, from_end ? windows.head : windows.tail);
      Time result = insert ? (from_end ? insertion_from_end_ : insertion_).run(priority, start)
                           : (from_end ? list_from_end_ : list_).run(priority, start);
      if (from_end) mirror(start, network_, result);
      result = justify(start, result);
      keep(start, result);
    }
}

// Timetable of disturbed priorities; `base` has priorities as ends in a timetable of the reversed network.
Time Improvement::disturbed(std::vector<Time> const &base, bool forward, Random &random, std::vector<Time> &start) {
  constexpr Time scale = 16;
  Time const longest = *std::ranges::max_element(network_.duration);
  auto const noise = static_cast<std::uint64_t>(std::max(Time{1}, (scale * longest << random.below(5)) / 4));
  // Disturbs all tasks, or those in an interval.
  Time const stretch = std::max(length_ >> random.below(5), Time{1});
  auto const first = static_cast<Time>(random.below(static_cast<std::uint64_t>(length_ - stretch + 1)));
  priority_.resize(base.size());
  for (std::size_t i = 0; i < base.size(); ++i) {
    priority_[i] = base[i] * scale;
    if (base[i] >= first && base[i] <= first + stretch) priority_[i] += static_cast<Time>(random.below(noise));
  }
  bool const insert = random.below(2) != 0;
  if (forward) return insert ? insertion_.run(priority_, start) : list_.run(priority_, start);
  Time const result = insert ? insertion_from_end_.run(priority_, start) : list_from_end_.run(priority_, start);
  mirror(start, network_, result);
  return result;
}

void Improvement::search(Windows const &windows, std::size_t steps, std::uint64_t seed) {
  Random random(seed);
  std::vector<Time> const tail = with_duration(network_, windows.tail), head = with_duration(network_, windows.head);
  std::vector<Time> current = start_, start, base;
  Time current_length = length_;
  for (std::size_t step = 0; step < steps && !is_enough(); ++step) {
    bool const forward = random.below(2) != 0;
    if (random.below(8) == 0) {
      base = forward ? tail : head;
    } else if (forward) {
      base.resize(current.size());
      for (std::size_t i = 0; i < current.size(); ++i) base[i] = current_length - current[i];
    } else {
      set_ends(base, network_, current);
    }
    Time result = disturbed(base, forward, random, start);
    result = justify(start, result);
    keep(start, result);
    if (result > current_length) continue;
    current_length = result;
    current.swap(start);
  }
}

} // namespace symreal
