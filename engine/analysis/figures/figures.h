// What `symreal analyze` says of a graph, from its operations to all figures.
#pragma once

#include "engine/analysis/costs/costs.h"
#include "engine/analysis/levels/levelled.h"

#include <optional>

namespace symreal {

// For how many units, or for which length, the levelled schedule is made; by default for the span.
struct Goal {
  std::uint32_t units = 0; // 0: for a length
  Time length = 0;         // 0: the span
};

struct LengthBound {
  std::uint32_t units;
  Time simple, by_levels; // level_bounds.h
};

// An operation of the critical path that costs something.
struct PathStep {
  NodeId node;
  Time start, duration;
};

// Of the operations that cost something.
struct SlackFigures {
  std::size_t none = 0; // how many have no slack
  Time median = 0, largest = 0;
};

struct Figures {
  OperationTasks operations;
  std::size_t count = 0; // of those that cost something: changes of sign do not, as a rule
  Levels levels;
  double throughput_work = 0; // in the costs' time unit: if no operation had to wait
  SlackFigures slack;
  std::vector<PathStep> critical_path;
  std::vector<LengthBound> bounds; // for 1, 2, 4, ... units, until the span is reached
  std::uint32_t least_units = 0;   // below which no schedule has the length of the levelled one
  Levelled levelled;
  LevelProfile from_inputs, from_outputs, evened;
};

// Throws nothing_to_analyze, cost_file; bad_option for a length below the span.
Figures figures(Graph const &graph, Costs const &costs, Goal const &goal);

} // namespace symreal
