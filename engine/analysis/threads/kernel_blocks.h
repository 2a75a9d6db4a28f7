// The operations of a kernel in blocks.
#pragma once

#include "engine/analysis/blocks/block_figures.h"
#include "engine/analysis/costs/costs.h"

namespace symreal {

struct KernelBlocks {
  OperationTasks operations; // each lasts as long as it occupies a core: its throughput
  Time scale = 1;            // these are so many parts of the costs' unit
  std::size_t count = 0;     // of operations that cost something
  Components components;
  Blocks blocks;
  BlockFigures figures;

  double in_unit(Time time) const { return static_cast<double>(time) / static_cast<double>(scale); }
};

// Throws nothing_to_analyze, cost_file, bad_option.
KernelBlocks cut_kernel(Graph const &graph, Costs const &costs, std::uint32_t count);

} // namespace symreal
