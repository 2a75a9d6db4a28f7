// Plan: what the emitters print. A schedule, and in place of its statements loops or vectors.
#pragma once

#include "engine/plan/lanes/lanes.h"
#include "engine/plan/reroll/reroll.h"

namespace symreal {

struct Plan {
  // A plan of statements alone is a schedule.
  Plan(Schedule schedule = {}, std::optional<Rerolled> loops = {}, std::optional<Laned> lanes = {})
      : schedule(std::move(schedule)),
        loops(std::move(loops)),
        lanes(std::move(lanes)) {}

  Schedule schedule;             // points to its graph
  std::optional<Rerolled> loops; // replace the statements of their functions
  std::optional<Laned> lanes;    // vector code of compute, beside its scalar code

  Graph const &graph() const { return *schedule.graph; }
};

} // namespace symreal
