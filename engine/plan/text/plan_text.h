// Text form of a plan: a dump of any stage of planning that can be read back; the tests of emitters use it.
//
//   symreal-plan 1
//   kernel "k"                       the lines of the graph (graph_text.h), without its first
//   ...
//   function preprocess              the functions of the plan, in the order of their kinds
//   set %1 f64                       the next statement, and the kind of its value: f64, truth, u64
//   store 0 %1                       slot of `constants`, or in function `angles` the number of a computed angle
//   function compute
//   region 1 %4 !%5 ?0               where node 4 and gate 0 hold, and node 5 does not; the outermost block first
//   region 2                         everywhere: its conditions were released
//   gate 0 any 1 2                   1 where one of these regions is; without `any`: 1 where it is computed
//   sin 0 %6                         element 0 of `sine` (angles.h); `cos`: of `cosine`
//   set %4 truth
//   set ?0 truth in 1                a gate; computed in region 1 only
//   set %9 f64 returned              a call whose returned value is read
//   part 0 of 2 threads              of stage 0: one thread computes the statements above, back to the part before
//   check 0                          of guard 0: compute returns its number unless it holds
//
// The results of compute are those of the graph. Loops, in place of the statements of a function, follow these:
//
//   loops 40 36 2                    the steps: operations, those in loops, loops
//   memory 3                         size of the function's own array
//   step 12                          iterations
//   nest 4 3 0                       turns of the outer loop, iterations of the inner one, growth per turn
//   leaf input 0 2                   input of the body: element 0 + 2 * iteration of an array (value.h)
//   leaf input of 0 3 4              an element per iteration
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
//
// And vectors, beside the statements of compute:
//
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
