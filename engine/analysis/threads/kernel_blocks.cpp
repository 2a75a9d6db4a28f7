#include "engine/analysis/threads/kernel_blocks.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace symreal {

namespace {

// Durations by throughput, in parts that hold the two decimals of measured costs; at least 1 for a nonzero cost.
OperationCosts occupation(Costs const &costs, Time scale) {
  OperationCosts result = costs.latency;
  for (std::size_t row = 0; costs.scale != 1 && row < result.size(); ++row)
    result[row] = std::max<Time>(std::llround(costs.throughput[row] * static_cast<double>(scale)), result[row] != 0);
  return result;
}

} // namespace

KernelBlocks cut_kernel(Graph const &graph, Costs const &costs, std::uint32_t count) {
  require_costs(costs, graph);
  KernelBlocks result;
  result.scale = costs.scale == 1 ? 1 : 100;
  result.operations = operation_tasks(graph, occupation(costs, result.scale));
  TaskGraph const &tasks = result.operations.tasks;
  result.count = tasks.size() - static_cast<std::size_t>(std::ranges::count(tasks.duration, 0));
  if (result.count == 0)
    fail(DiagnosticId::nothing_to_analyze, {},
         fmt::format("kernel '{}' has no operation that costs something", graph.kernel));
  if (result.count < count)
    fail(DiagnosticId::bad_option, {},
         fmt::format("kernel '{}' has {} operations that cost something, and {} blocks are asked for", graph.kernel,
                     result.count, count));
  result.components = components(tasks);
  result.blocks = partition(tasks, result.components, count);
  result.figures = block_figures(tasks, result.blocks);
  return result;
}

} // namespace symreal
