// Scheduling: from a graph to a plan of statements.
#pragma once

#include "engine/plan/plan.h"

#include <vector>

namespace symreal {

// Statements per part of a long function, unless its language sets another limit; longer bodies are cut.
inline constexpr std::size_t usual_part_length = 500;

// Slots of `constants`: per node the last slot that stores it, or no_slot.
std::vector<std::uint32_t> constant_slots(Graph const &graph, std::vector<NodeId> const &stored);

// Whether the operands of a select's arms are computed in blocks under the condition, or always.
enum class Arms { in_blocks, computed };

// Statements keep the order of recording; if that needs more registers than there are, list scheduling replaces it
// where that spills fewer values. Conditional operations follow their condition. `graph` must outlive the plan.
Plan schedule(Graph const &graph, Nesting nesting = Nesting::bounded, Arms arms = Arms::in_blocks);

// Layout of an extra function that reads the same arrays as compute.
PlanFunction lay_out(FunctionKind kind, std::vector<NodeId> const &results, Plan const &plan);

inline constexpr unsigned most_threads = 64;

// Stage and thread that execute a statement of compute.
struct Share {
  std::uint32_t stage = 0, thread = 0;
};

// Sorts the statements of compute by stage and thread, stably. `shares`: per statement. No statement may
// precede its operands in that order.
Plan shared_out(Plan const &plan, std::vector<Share> const &shares, unsigned threads);

// The form in which a language takes plans.
struct PlanForm {
  bool has_blocks = true;  // else both arms of decisions are computed
  bool has_angles = false; // sines and cosines side by side at the start (angles.h)
  auto operator<=>(PlanForm const &) const = default;
};

// The plan in this form. A plan with loops, vectors or threads keeps its blocks: only languages with blocks have those.
Plan in_form(Plan plan, PlanForm const &form);

} // namespace symreal
