// Figures of `symreal analyze` for a graph.
#pragma once

#include "engine/analysis/costs/costs.h"
#include "engine/analysis/levels/levelled.h"

#include <optional>

namespace symreal {

// Goal of the levelled schedule: a number of units or a length, by default the span.
struct Goal {
  std::uint32_t units = 0; // 0: for a length
  Time length = 0;         // 0: the span
};

struct LengthBound {
  std::uint32_t units;
  Time simple, by_levels; // LevelBounds
};

// An operation of nonzero cost on the critical path.
struct PathStep {
  NodeId node;
  Time start, duration;
};

// Slack of the operations of nonzero cost.
struct SlackFigures {
  std::size_t none = 0; // number of operations without slack
  Time median = 0, largest = 0;
};

struct Figures {
  OperationTasks operations;
  std::size_t count = 0; // of operations of nonzero cost; changes of sign are usually free
  Levels levels;
  double throughput_work = 0; // in the costs' time unit, if operations never had to wait
  SlackFigures slack;
  std::vector<PathStep> critical_path;
  std::vector<LengthBound> bounds; // for 1, 2, 4, ... units, up to the span
  std::uint32_t least_units = 0;   // lower bound for the length of the levelled schedule
  Levelled levelled;
  LevelProfile from_inputs, from_outputs, evened;
};

// Throws nothing_to_analyze, cost_file; bad_option for a length below the span.
Figures figures(Graph const &graph, Costs const &costs, Goal const &goal);

} // namespace symreal
