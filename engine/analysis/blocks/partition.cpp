#include "engine/analysis/blocks/partition.h"

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <array>
#include <metis.h>
#include <numeric>

namespace symreal {

namespace {

constexpr double tolerance = 1.05;          // ratio of the largest to the mean work up to which components stay uncut
constexpr std::uint32_t most_halved = 8;    // METIS bisects recursively up to this number of blocks
constexpr Time most_weight = Time{1} << 30; // of all tasks together: METIS uses 32-bit weights

// Distributes components, longest first, each to the block with the least work.
std::vector<BlockId> share_out(Components const &components, std::uint32_t count) {
  std::vector<std::uint32_t> order(components.work.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, [&](auto a, auto b) { return components.work[a] > components.work[b]; });
  std::vector<std::pair<Time, BlockId>> heap; // min-heap by work
  for (BlockId block = 0; block < count; ++block) heap.emplace_back(0, block);
  std::vector<BlockId> block_of(components.work.size());
  for (std::uint32_t component : order) {
    std::ranges::pop_heap(heap, std::greater<>());
    block_of[component] = heap.back().second;
    heap.back().first += components.work[component];
    std::ranges::push_heap(heap, std::greater<>());
  }
  std::vector<BlockId> result;
  for (std::uint32_t component : components.of_task) result.push_back(block_of[component]);
  return result;
}

std::vector<Time> work_of(TaskGraph const &graph, std::vector<BlockId> const &block, std::uint32_t count) {
  std::vector<Time> work(count);
  for (TaskId task = 0; task < graph.size(); ++task) work[block[task]] += graph.duration[task];
  return work;
}

bool is_even(std::vector<Time> const &work) {
  Time const all = std::accumulate(work.begin(), work.end(), Time{0});
  return static_cast<double>(*std::ranges::max_element(work)) * static_cast<double>(work.size()) <=
         tolerance * static_cast<double>(all);
}

std::vector<BlockId> cut_by_metis(TaskGraph const &graph, std::uint32_t count) {
  Successors const next = successors(graph);
  Time const all = std::accumulate(graph.duration.begin(), graph.duration.end(), Time{0});
  Time const divisor = all / most_weight + 1;
  std::vector<idx_t> first = {0}, neighbour, weight, block(graph.size());
  for (TaskId task = 0; task < graph.size(); ++task) {
    for (TaskId other : graph.predecessors(task)) neighbour.push_back(static_cast<idx_t>(other));
    for (TaskId other : next.of(task)) neighbour.push_back(static_cast<idx_t>(other));
    first.push_back(static_cast<idx_t>(neighbour.size()));
    weight.push_back(static_cast<idx_t>((graph.duration[task] + divisor - 1) / divisor));
  }
  std::array<idx_t, METIS_NOPTIONS> options;
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = 1;
  options[METIS_OPTION_NCUTS] = 4;
  idx_t vertices = static_cast<idx_t>(graph.size()), constraints = 1, parts = static_cast<idx_t>(count), cut = 0;
  auto *const method = count <= most_halved ? METIS_PartGraphRecursive : METIS_PartGraphKway;
  if (method(&vertices, &constraints, first.data(), neighbour.data(), weight.data(), nullptr, nullptr, &parts, nullptr,
             nullptr, options.data(), &cut, block.data()) != METIS_OK)
    fail(DiagnosticId::bad_option, {}, "METIS cannot cut this graph into so many blocks");
  return {block.begin(), block.end()};
}

// METIS leaves blocks empty in small graphs; each of these takes a task of the fullest block.
void fill_empty(TaskGraph const &graph, std::vector<BlockId> &block, std::uint32_t count) {
  std::vector<std::vector<TaskId>> tasks(count);
  for (TaskId task = 0; task < graph.size(); ++task)
    if (graph.duration[task] != 0) tasks[block[task]].push_back(task);
  for (BlockId empty = 0; empty < count; ++empty) {
    if (!tasks[empty].empty()) continue;
    auto const fullest = std::ranges::max_element(tasks, {}, [](auto const &all) { return all.size(); });
    block[fullest->back()] = empty;
    tasks[empty].push_back(fullest->back());
    fullest->pop_back();
  }
}

void number_by_first_tasks(Blocks &blocks) {
  std::vector<BlockId> number(blocks.count, blocks.count);
  BlockId next = 0;
  for (BlockId &block : blocks.of_task) {
    if (number[block] == blocks.count) number[block] = next++;
    block = number[block];
  }
}

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

std::size_t Components::count() const {
  return tasks.size() - static_cast<std::size_t>(std::ranges::count(tasks, std::size_t{0}));
}

std::size_t Components::largest() const { return tasks.empty() ? 0 : *std::ranges::max_element(tasks); }

Components components(TaskGraph const &graph) {
  // The root of a set is its oldest task, which therefore gets its number first.
  std::vector<TaskId> parent(graph.size());
  std::iota(parent.begin(), parent.end(), TaskId{0});
  for (TaskId task = 0; task < graph.size(); ++task)
    for (TaskId before : graph.predecessors(task)) {
      TaskId const a = root(parent, task), b = root(parent, before);
      parent[std::max(a, b)] = std::min(a, b);
    }
  Components result;
  result.of_task.resize(graph.size());
  for (TaskId task = 0; task < graph.size(); ++task) {
    TaskId const oldest = root(parent, task);
    if (oldest == task) {
      result.of_task[task] = static_cast<std::uint32_t>(result.tasks.size());
      result.tasks.push_back(0);
      result.work.push_back(0);
    }
    std::uint32_t const number = result.of_task[task] = result.of_task[oldest];
    result.tasks[number] += graph.duration[task] != 0;
    result.work[number] += graph.duration[task];
  }
  return result;
}

Blocks partition(TaskGraph const &graph, Components const &components, std::uint32_t count) {
  Blocks result{count, std::vector<BlockId>(graph.size())};
  if (count == 1) return result;
  result.of_task = share_out(components, count);
  if (!is_even(work_of(graph, result.of_task, count))) result.of_task = cut_by_metis(graph, count);
  fill_empty(graph, result.of_task, count);
  number_by_first_tasks(result);
  return result;
}

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
  result.work = work_of(graph, blocks.of_task, blocks.count);
  TaskGraph without_time = graph;
  std::ranges::fill(without_time.duration, 0);
  for (TaskId task = 0; task < graph.size(); ++task) result.operations[blocks[task]] += graph.duration[task] != 0;
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
