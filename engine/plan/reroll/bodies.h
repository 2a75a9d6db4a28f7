// Bodies made cheaper by passes, each by itself: for mode fast.
//
// A search in the whole graph treats equal windows unequally, so that nothing repeats any more. So loops are found
// before it, and it works on their bodies: a search in a thousandth of the operations serves all of them.
#pragma once

#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/schedule/schedule.h"

#include <functional>

namespace symreal::reroll {

// Passes over a graph that has been made of a body; `in_loop`: it is computed more than once.
using Improve = std::function<Graph(Graph graph, bool in_loop)>;

// A step with less to compute, or as it is. For the passes, what stands in tables of constants is a parameter, and what
// depends on nothing else goes into the tables, evaluated here row by row; elements of `sine` and `cosine` are the sine
// and cosine of an input. `angles`: those of the schedule.
Step improved(Step const &step, Angles const &angles, Improve const &improve);

// How many operations a body has, and a step in all its iterations.
std::size_t operations_of(Graph const &body);
std::size_t operations_of(Step const &step);

// All steps, and what the function counts.
void improve_bodies(LoopFunction &function, Angles const &angles, Improve const &improve);

} // namespace symreal::reroll
