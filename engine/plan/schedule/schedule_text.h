// Text form of a schedule, which the tests of emitters use.
//
//   symreal-plan 1
//   kernel "k"                       the lines of the graph (graph_text.h), without its first
//   ...
//   function preprocess
//   set %1                           the next statement
//   store 0 %1                       slot of `constants`
//   function compute
//   region 1 %4 !%5 ?0               where node 4 and gate 0 hold, and node 5 does not; the outermost block first
//   region 2                         everywhere: its conditions were released
//   gate 0 any 1 2                   1 where one of these regions is; without `any`: 1 where it is computed
//   set %4
//   set ?0 in 1                      a gate; computed in region 1 only
//   set %9 returned                  a call whose returned value is read
//   part 0 of 2 threads              of stage 0: one thread computes the statements above, back to the part before
//   check 0                          of guard 0
//
// The results of compute are those of the graph.
#pragma once

#include "engine/plan/schedule/schedule.h"

#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

namespace symreal {

void write_schedule(std::ostream &out, Schedule const &plan);

bool is_schedule(std::string_view text);

// A schedule and the graph that it points to.
struct ReadSchedule {
  std::unique_ptr<Graph> graph;
  Schedule plan;
};
// Throws graph_syntax at the first invalid line.
ReadSchedule read_schedule(std::string_view text, std::string const &file_name);

} // namespace symreal
