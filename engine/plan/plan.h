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

// The form in which a language takes plans.
struct PlanForm {
  bool has_blocks = true;  // else both arms of decisions are computed
  bool has_angles = false; // sines and cosines side by side at the start (schedule/angles.h)
  auto operator<=>(PlanForm const &) const = default;
};

// The plan in this form. A plan with loops, vectors or threads keeps its blocks: only languages with blocks have those.
Plan in_form(Plan plan, PlanForm const &form);

} // namespace symreal
