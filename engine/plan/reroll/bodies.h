// Optimisation passes over loop bodies, each on its own, for mode fast.
//
// A search over the whole graph treats equal windows differently and so destroys repeats. Loops are therefore found
// first, and the search works on a body: a thousandth of the operations, for the benefit of all iterations.
#pragma once

#include "engine/plan/loop_function.h"
#include "engine/plan/plan.h"

#include <functional>

namespace symreal::reroll {

// Passes over the graph of a body; `in_loop`: the body is computed more than once.
using Improve = std::function<Graph(Graph graph, bool in_loop)>;

// A step with fewer operations, else the step unchanged. To the passes, table constants are parameters, and nodes that
// depend on parameters alone move into the tables, evaluated here row by row; elements of `sine` and `cosine` are the
// sine and cosine of an input. `angles`: those of the plan.
LoopStep improved(LoopStep const &step, Angles const &angles, Improve const &improve);

// Operation count of a body, and of a step over all its iterations.
std::size_t operations_of(Graph const &body);
std::size_t operations_of(LoopStep const &step);

// Improves all steps and updates the operation counts of the function.
void improve_bodies(LoopFunction &function, Angles const &angles, Improve const &improve);

} // namespace symreal::reroll
