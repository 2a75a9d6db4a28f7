#include "engine/analysis/blocks/block_figures.h"

#include <algorithm>
#include <numeric>

namespace symreal {

namespace {

using Crossing = std::pair<BlockId, BlockId>; // from, to

std::vector<Crossing> crossings(TaskGraph const &graph, Blocks const &blocks) {
  std::vector<Crossing> result;
  for (TaskId task = 0; task < graph.size(); ++task)
    for (TaskId before : graph.predecessors(task))
      if (blocks[before] != blocks[task]) result.emplace_back(blocks[before], blocks[task]);
  return result;
}

std::size_t volume(TaskGraph const &graph, Blocks const &blocks) {
  Successors const next = successors(graph);
  std::vector<TaskId> last_sender(blocks.count, static_cast<TaskId>(graph.size()));
  std::size_t result = 0;
  for (TaskId task = 0; task < graph.size(); ++task)
    for (TaskId after : next.of(task))
      if (BlockId const to = blocks[after]; to != blocks[task] && last_sender[to] != task) {
        last_sender[to] = task;
        ++result;
      }
  return result;
}

// Length of the longest chain of dependent blocks; nullopt if they form a cycle.
std::optional<std::size_t> depth(std::vector<Crossing> edges, std::uint32_t count) {
  std::ranges::sort(edges);
  edges.erase(std::ranges::unique(edges).begin(), edges.end());
  std::vector<std::size_t> waits_for(count), level(count, 1);
  for (auto const &[from, to] : edges) ++waits_for[to];
  std::vector<BlockId> ready;
  for (BlockId block = 0; block < count; ++block)
    if (waits_for[block] == 0) ready.push_back(block);
  for (std::size_t k = 0; k < ready.size(); ++k)
    for (auto edge = std::ranges::lower_bound(edges, Crossing{ready[k], 0});
         edge != edges.end() && edge->first == ready[k]; ++edge) {
      level[edge->second] = std::max(level[edge->second], level[ready[k]] + 1);
      if (--waits_for[edge->second] == 0) ready.push_back(edge->second);
    }
  if (ready.size() != count) return {};
  return *std::ranges::max_element(level);
}

} // namespace

Time span_of_blocks(TaskGraph const &graph, Blocks const &blocks, Time hand_over) {
  std::vector<Time> end(graph.size());
  for (TaskId task = 0; task < graph.size(); ++task) {
    for (TaskId before : graph.predecessors(task))
      end[task] = std::max(end[task], end[before] + (blocks[before] != blocks[task] ? hand_over : 0));
    end[task] += graph.duration[task];
  }
  return end.empty() ? 0 : *std::ranges::max_element(end);
}

Time length_in_order(TaskGraph const &graph, Blocks const &blocks, Time hand_over) {
  std::vector<Time> end(graph.size()), free_at(blocks.count);
  for (TaskId task = 0; task < graph.size(); ++task) {
    end[task] = free_at[blocks[task]];
    for (TaskId before : graph.predecessors(task))
      end[task] = std::max(end[task], end[before] + (blocks[before] != blocks[task] ? hand_over : 0));
    free_at[blocks[task]] = end[task] += graph.duration[task];
  }
  return *std::ranges::max_element(free_at);
}

BlockFigures block_figures(TaskGraph const &graph, Blocks const &blocks) {
  BlockFigures result;
  result.operations.resize(blocks.count);
  result.work.resize(blocks.count);
  TaskGraph without_time = graph;
  std::ranges::fill(without_time.duration, 0);
  for (TaskId task = 0; task < graph.size(); ++task) {
    result.operations[blocks[task]] += graph.duration[task] != 0;
    result.work[blocks[task]] += graph.duration[task];
  }
  Time const all = std::accumulate(result.work.begin(), result.work.end(), Time{0});
  if (all != 0)
    result.balance =
        static_cast<double>(*std::ranges::max_element(result.work)) * blocks.count / static_cast<double>(all);
  std::vector<Crossing> const edges = crossings(graph, blocks);
  result.cut = edges.size();
  result.volume = volume(graph, blocks);
  result.hand_overs = static_cast<std::size_t>(span_of_blocks(without_time, blocks, 1));
  result.depth = depth(edges, blocks.count);
  return result;
}

} // namespace symreal
