// Thread advice: whether threads pay for one evaluation of a kernel, and their rate for many, in nanoseconds. Times are
// lower bounds: a program also loads, stores, and shares caches. So threads do not pay if their bound exceeds that of
// one core; if it is below, only a measurement can tell.
#pragma once

#include "engine/analysis/blocks/partition.h"
#include "engine/analysis/costs/costs.h"

namespace symreal {

// Operations of a kernel, partitioned into blocks.
struct KernelBlocks {
  OperationTasks operations; // durations are throughputs: the time on a core
  Time scale = 1;            // parts of the costs' unit in durations
  std::size_t count = 0;     // of operations of nonzero cost
  Components components;
  Blocks blocks;
  BlockFigures figures;

  double in_unit(Time time) const { return static_cast<double>(time) / static_cast<double>(scale); }
};

// Throws nothing_to_analyze, cost_file, bad_option.
KernelBlocks cut_kernel(Graph const &graph, Costs const &costs, std::uint32_t count);

struct Advice {
  unsigned threads = 0; // one per block
  double one_core = 0;  // the larger of work and longest path

  // Level by level: all threads execute a level, then meet at a barrier.
  std::size_t levels = 0; // of operations of nonzero cost
  double barrier = 0;
  double by_levels = 0;
  double level_width = 0;  // operations per level, on average
  double width_to_pay = 0; // operations per level from which a barrier pays

  // Block by block: each thread executes a block and hands values over; the first one also announces the work and
  // learns of its end.
  double hand_over = 0;
  std::size_t hand_overs = 0; // on the longest chain, those two included
  double by_blocks = 0;
  double in_order = 0;    // estimate, not a bound: each thread computes in graph order
  double time_to_pay = 0; // time on one core from which the hand-overs pay at this balance

  // Batch: each thread evaluates its own samples.
  double batch_rate = 0;        // samples per second
  std::size_t batch_to_pay = 0; // samples from which waking the other threads pays

  double best() const { return by_levels < by_blocks ? by_levels : by_blocks; }
  bool pays() const { return best() < one_core; }
  bool pays_in_order() const { return in_order < one_core; }
};

// `costs` must have measured threads; the kernel has at least two blocks.
Advice advise(Graph const &graph, Costs const &costs, KernelBlocks const &kernel);

} // namespace symreal
