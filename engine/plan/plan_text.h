// Text form of a plan: a dump of any stage of planning that can be read back; the tests of emitters use it. A plan
// without loops and vectors is a schedule (schedule_text.h); else these lines follow those of the schedule:
//
//   angles                           compute begins with sines and cosines (angles.h)
//   loops compute 40 36 2            the steps of a function: operations, those in loops, loops
//   memory 3                         size of the function's own array
//   step 12                          iterations
//   nest 4 3 0                       turns of the outer loop, iterations of the inner one, growth per turn
//   leaf given 0 2                   input of the body: element 0 + 2 * iteration; `read`, `sine`, `cosine`, `memory`
//   leaf given of 0 3 4              an element per iteration
//   leaf values 0.5 2                a table that repeats; `by turn`: a row per turn of the outer loop
//   leaf carried 0 0 next %1         loop-carried: memory first, then the previous iteration's %1
//   body                             a graph (graph_text.h) without its first line, and without the locations and
//   tables kernel "k"                       of the plan's graph
//   ...
//   end
//   store memory 0 0                 at the end of each iteration, in the order of the body's results
//   store output 0 1
//   mirror 4 3 from above            result 4 is the first of a symmetric 3x3 matrix: its lower half is copied
//   check 2                          per guard: the element of memory that must be nonzero
//   lanes 4 20 16                    vectors of 4 numbers in compute: operations, those in vectors
//   vector load input 8 : %1 %2 - -  vectors are numbered from 0 on; the nodes that the lanes hold, `-` for none
//   vector splat : %5
//   vector constants : 1 2 3 4
//   vector build : %1 %7 2 %3
//   vector shuffle 0 1 takes 0 4 1 5 : %1 %2 %3 %4
//   vector sub 2 3 : %8 %9 ~%10 -    `~`: a scalar operation, or another vector, computes the node for all other uses
//   vector add 2 3 subtracts 0 1 0 1 : ...
//   compute vector 0                 the order of vectors and scalar operations
//   compute %12
//   store vector 3 at 4              to results 4 to 7
#pragma once

#include "engine/plan/plan.h"

#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

namespace symreal {

void write_plan(std::ostream &out, Plan const &plan);

bool is_plan(std::string_view text);

// A plan and the graph that it points to.
struct ReadPlan {
  std::unique_ptr<Graph> graph;
  Plan plan;
};
// Throws graph_syntax at the first invalid line. Loops are checked for what they read and store, vectors also for the
// values that they hold: passes may have changed the bodies of loops in ways that only real numbers permit.
ReadPlan read_plan(std::string_view text, std::string const &file_name);

} // namespace symreal
