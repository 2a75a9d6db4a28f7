// Whether threads pay for one evaluation of a kernel, and what they give for many. Nanoseconds. All times are bounds: a
// program takes longer, as it also loads, stores, and shares caches. So where the bound of threads is above that of one
// core, threads do not pay; where it is below, a program must show it.
#pragma once

#include "engine/analysis/threads/kernel_blocks.h"

namespace symreal {

struct Advice {
  unsigned threads = 0; // as many as blocks
  double one_core = 0;  // the larger of work and longest path

  // All threads do a level, wait for each other, do the next one.
  std::size_t levels = 0; // of operations that cost something
  double barrier = 0;
  double by_levels = 0;
  double level_width = 0;  // operations per level, on average
  double width_to_pay = 0; // so many of these operations are worth a barrier

  // Each thread does a block and hands values over; the first one also says that there is something to do, and learns
  // that it is done.
  double hand_over = 0;
  std::size_t hand_overs = 0; // one after the other, those two included
  double by_blocks = 0;
  double in_order = 0;    // no bound: if each thread computes in the order of the graph
  double time_to_pay = 0; // what takes so long on one core is worth so many hand-overs, if it is cut as evenly

  // Each thread evaluates samples of its own.
  double batch_rate = 0;        // samples per second
  std::size_t batch_to_pay = 0; // samples that are worth waking the other threads

  double best() const { return by_levels < by_blocks ? by_levels : by_blocks; }
  bool pays() const { return best() < one_core; }
  bool pays_in_order() const { return in_order < one_core; }
};

// For costs whose threads are measured, and two blocks at least.
Advice advise(Graph const &graph, Costs const &costs, KernelBlocks const &kernel);

} // namespace symreal
