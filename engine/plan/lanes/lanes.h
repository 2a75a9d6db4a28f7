// --vector: operations of one kind side by side, as vectors.
//
// A recorded program is one long sequence of operations, in which what a loop or three coordinates had in common can no
// longer be seen by compilers: their vectorisers of straight-line code find little of it, and gcc's fuses what must not
// be fused. Here isomorphic operations are sought in the graph and become operations on vectors, lane by lane: each
// number is computed by the same operations as before. docs/reference/lanes.md says more.
#pragma once

#include "engine/plan/lanes/lane_program.h"
#include "engine/plan/schedule/schedule.h"

#include <optional>
#include <string>

namespace symreal {

struct Laned {
  std::optional<lanes::LaneFunction> compute;
  std::string why_not = {}; // where it has no vectors
};

// Function compute of the schedule with vectors of `width` numbers. What is found is proved (check.h) whenever this
// runs.
Laned laned(Schedule const &plan, std::size_t width);

// How much of the operations stands in vectors, in words.
std::string describe(lanes::LaneFunction const &function);

} // namespace symreal
