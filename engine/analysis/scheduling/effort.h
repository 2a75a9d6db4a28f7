// How much is tried. Counted in steps, not in seconds: so the result is the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace symreal {

// Beyond this many tasks there is time for one list only.
inline constexpr std::size_t most_searched_tasks = 20'000;
inline constexpr unsigned most_effort = 3;

struct Effort {
  unsigned level = 1; // 0: lists only; 1: a second or so; 2, 3: ten times as much each
  std::uint64_t seed = 1;

  // Of timetables that the local search makes; `cost` is that of placing a task.
  std::size_t search_steps(std::size_t tasks, std::size_t cost = 1) const;
  // Of an exact search; 0: none. Up to 30 tasks there are enough to come to the end.
  std::uint64_t exact_nodes(std::size_t tasks) const;
};

} // namespace symreal
