// Kernel blocks: the operations of a kernel, partitioned into blocks.
#pragma once

#include "engine/analysis/blocks/block_figures.h"
#include "engine/analysis/costs/costs.h"

namespace symreal {

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

} // namespace symreal
