// --vector: packs isomorphic operations into vectors.
//
// A recorded program is one long sequence of operations, which hides the structure of its loops and coordinates from
// compilers: their SLP vectorisers find little, and gcc's fuses operations that must not be fused. This pass finds
// isomorphic operations in the graph and computes them as vector operations, lane by lane: each number results from the
// same operations as before. Details: docs/reference/lanes.md.
#pragma once

#include "engine/plan/plan.h"

#include <optional>
#include <string>

namespace symreal {

struct Laned {
  std::optional<lanes::LaneFunction> compute;
  std::string why_not = {}; // the reason, if it has no vectors
};

// Reason why compute cannot have vectors; empty if it can.
std::string obstacle_to_lanes(Plan const &plan);

// Function compute of the plan with vectors of `width` numbers. The result is always proved (check.h).
Laned laned(Plan const &plan, std::size_t width);

// Description of the share of operations in vectors.
std::string describe(lanes::LaneFunction const &function);

} // namespace symreal
