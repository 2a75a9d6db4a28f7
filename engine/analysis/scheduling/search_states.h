// States of exact searches: sets of tasks, and a table of the states that were seen.
#pragma once

#include "engine/analysis/scheduling/random.h"
#include "engine/analysis/tasks/task_graph.h"

#include <array>
#include <bit>

namespace symreal {

// Set of up to 64 tasks as the bits of a word.
using TaskSet = std::uint64_t;
inline TaskSet set_of(TaskId task) { return TaskSet{1} << task; }

template <class Visit> void for_each(TaskSet set, Visit visit) {
  for (; set != 0; set &= set - 1) visit(static_cast<TaskId>(std::countr_zero(set)));
}

// 128-bit hash of the added words; collisions are negligible.
class StateKey {
public:
  void add(std::uint64_t word) {
    low_ = mix(low_ ^ word);
    high_ = mix(high_ + word * 0x9e3779b97f4a7c15 + 1);
  }
  std::uint64_t low() const { return low_; }
  std::uint64_t high() const { return high_; }
  bool operator==(StateKey const &) const = default;

private:
  std::uint64_t low_ = 0x243f6a8885a308d3, high_ = 0x13198a2e03707344;
};

// Transposition table of search states with their earliest times. Fixed size: newer states replace older ones.
class SeenStates {
public:
  explicit SeenStates(std::size_t size_as_power_of_two) : entries_(std::size_t{1} << size_as_power_of_two) {}

  // Whether the state was visited at this time or earlier; records it otherwise.
  bool was_seen(StateKey const &key, Time at) {
    Entry &entry = entries_[key.low() & (entries_.size() - 1)];
    if (entry.is_used && entry.key == key && entry.at <= at) return true;
    entry = {key, at, true};
    return false;
  }

private:
  struct Entry {
    StateKey key;
    Time at = 0;
    bool is_used = false;
  };
  std::vector<Entry> entries_;
};

} // namespace symreal
