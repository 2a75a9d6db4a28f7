// Search effort, counted in steps rather than seconds, so that results are equal on all machines.
#pragma once

#include <cstddef>
#include <cstdint>

namespace symreal {

// Larger graphs get a single list schedule.
inline constexpr std::size_t most_searched_tasks = 20'000;
inline constexpr unsigned most_effort = 3;

struct Effort {
  unsigned level = 1; // 0: lists only; 1: about a second; 2, 3: ten times as much each
  std::uint64_t seed = 1;

  // Number of timetables that the local search tries; `cost` is that of placing a task.
  std::size_t search_steps(std::size_t tasks, std::size_t cost = 1) const;
  // Node limit of the exact search, 0 for no search. It suffices for up to 30 tasks.
  std::uint64_t exact_nodes(std::size_t tasks) const;
};

} // namespace symreal
