#include "engine/analysis/blocks/advice.h"

#include "engine/analysis/levels/levels.h"

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

Advice advise(Graph const &graph, Costs const &costs, KernelBlocks const &kernel) {
  internal_check(costs.threads.has_value());
  ThreadCosts const &threads = *costs.threads;
  TaskGraph const waiting = operation_tasks(graph, costs.latency).tasks;
  double const work = kernel.in_unit(levels(kernel.operations.tasks).work);
  double const largest = kernel.in_unit(*std::ranges::max_element(kernel.figures.work));
  double const span = costs.in_unit(levels(waiting).span);
  Advice result;
  result.threads = kernel.blocks.count;
  double const saved = 1 - 1.0 / result.threads; // largest saved fraction of the work
  result.one_core = std::max(work, span);

  result.levels = static_cast<std::size_t>(levels(operation_tasks(graph, unit_costs()).tasks).span);
  result.barrier = threads.barrier(result.threads);
  result.by_levels = std::max(work / result.threads, span) + static_cast<double>(result.levels) * result.barrier;
  result.level_width = static_cast<double>(kernel.count) / static_cast<double>(std::max<std::size_t>(result.levels, 1));
  result.width_to_pay = result.barrier / (saved * work / static_cast<double>(kernel.count));

  result.hand_over = threads.hand_over;
  result.hand_overs = kernel.figures.hand_overs + 2;
  auto const parts = static_cast<Time>(std::llround(result.hand_over * static_cast<double>(costs.scale)));
  result.by_blocks =
      std::max(largest, costs.in_unit(span_of_blocks(waiting, kernel.blocks, parts))) + 2 * result.hand_over;
  auto const parts_of_work = static_cast<Time>(std::llround(result.hand_over * static_cast<double>(kernel.scale)));
  result.in_order = std::max(kernel.in_unit(length_in_order(kernel.operations.tasks, kernel.blocks, parts_of_work)) +
                                 2 * result.hand_over,
                             result.by_blocks);
  result.time_to_pay = static_cast<double>(result.hand_overs) * result.hand_over / (1 - largest / work);

  result.batch_rate = 1e9 * result.threads / result.one_core;
  result.batch_to_pay = static_cast<std::size_t>(std::ceil(threads.wake / (saved * result.one_core)));
  return result;
}

} // namespace symreal
