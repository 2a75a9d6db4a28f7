#include "engine/analysis/blocks/partition.h"

#include "random_tasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace symreal {
namespace {

std::size_t with_time(TaskGraph const &graph) {
  return graph.size() - static_cast<std::size_t>(std::ranges::count(graph.duration, 0));
}

// Calls `check` with graphs of every shape, cut into some numbers of blocks that they allow.
template <class Check> void for_all_blocks(Check const &check) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    TaskGraph const graph = random_tasks(seed);
    Components const parts = components(graph);
    for (std::uint32_t count : {1U, 2U, 3U, 5U, 10U}) {
      if (count > with_time(graph)) break;
      SCOPED_TRACE(testing::Message() << "graph " << seed << ", " << count << " blocks");
      check(graph, parts, partition(graph, parts, count));
    }
  }
}

TEST(Blocks, EveryTaskIsInOneBlockAndEveryBlockHasATask) {
  for_all_blocks([](TaskGraph const &graph, Components const &, Blocks const &blocks) {
    ASSERT_EQ(blocks.of_task.size(), graph.size());
    std::set<BlockId> used;
    for (TaskId task = 0; task < graph.size(); ++task) {
      ASSERT_LT(blocks[task], blocks.count);
      if (graph.duration[task] != 0) used.insert(blocks[task]);
    }
    EXPECT_EQ(used.size(), blocks.count);
  });
}

TEST(Blocks, TheSameGraphGivesTheSameBlocks) {
  for_all_blocks([](TaskGraph const &graph, Components const &parts, Blocks const &blocks) {
    EXPECT_EQ(partition(graph, parts, blocks.count).of_task, blocks.of_task);
  });
}

// By their definitions, over all pairs.
TEST(Blocks, CutAndVolumeAreWhatCrosses) {
  for_all_blocks([](TaskGraph const &graph, Components const &, Blocks const &blocks) {
    std::size_t cut = 0;
    std::set<std::pair<TaskId, BlockId>> received;
    for (TaskId from = 0; from < graph.size(); ++from)
      for (TaskId to = 0; to < graph.size(); ++to) {
        auto const before = graph.predecessors(to);
        if (std::ranges::find(before, from) == before.end() || blocks[from] == blocks[to]) continue;
        ++cut;
        received.emplace(from, blocks[to]);
      }
    BlockFigures const figures = block_figures(graph, blocks);
    EXPECT_EQ(figures.cut, cut);
    EXPECT_EQ(figures.volume, received.size());
  });
}

TEST(Blocks, AllWorkIsInBlocks) {
  for_all_blocks([](TaskGraph const &graph, Components const &, Blocks const &blocks) {
    BlockFigures const figures = block_figures(graph, blocks);
    Time const work = std::accumulate(graph.duration.begin(), graph.duration.end(), Time{0});
    EXPECT_EQ(std::accumulate(figures.work.begin(), figures.work.end(), Time{0}), work);
    EXPECT_EQ(std::accumulate(figures.operations.begin(), figures.operations.end(), std::size_t{0}), with_time(graph));
    EXPECT_GE(figures.balance, 1 - 1e-12);
  });
}

TEST(Blocks, AChainOfBlocksHasAsManyHandOversAtMostAsThereAreCrossings) {
  for_all_blocks([](TaskGraph const &graph, Components const &, Blocks const &blocks) {
    BlockFigures const figures = block_figures(graph, blocks);
    EXPECT_LE(figures.hand_overs, figures.cut);
    EXPECT_EQ(figures.hand_overs == 0, figures.cut == 0);
    if (figures.depth) {
      EXPECT_LE(figures.hand_overs, *figures.depth - 1);
    }
  });
}

// Two tasks are in one component if a number can be carried from one to the other over edges, whatever their direction.
TEST(Components, AreWhatAFloodReaches) {
  for (unsigned seed = 0; seed < random_graphs; ++seed) {
    TaskGraph const graph = random_tasks(seed);
    std::vector<TaskId> least(graph.size());
    std::iota(least.begin(), least.end(), TaskId{0});
    for (bool changes = true; changes;) {
      changes = false;
      for (TaskId task = 0; task < graph.size(); ++task)
        for (TaskId before : graph.predecessors(task))
          if (TaskId const low = std::min(least[task], least[before]); least[task] != least[before]) {
            least[task] = least[before] = low;
            changes = true;
          }
    }
    Components const parts = components(graph);
    EXPECT_EQ(parts.tasks.size(), std::set<TaskId>(least.begin(), least.end()).size()) << seed;
    for (TaskId a = 0; a < graph.size(); ++a)
      for (TaskId b = 0; b < a; ++b) EXPECT_EQ(parts.of_task[a] == parts.of_task[b], least[a] == least[b]) << seed;
    EXPECT_EQ(std::accumulate(parts.tasks.begin(), parts.tasks.end(), std::size_t{0}), with_time(graph)) << seed;
  }
}

TEST(Components, OfEqualWorkAreSharedOutWithoutAnyCrossing) {
  TaskGraph graph;
  std::vector<TaskId> last(4);
  for (TaskId task = 0; task < 40; ++task) {
    graph.add(1, task < 4 ? std::span<TaskId const>() : std::span<TaskId const>(&last[task % 4], 1));
    last[task % 4] = task;
  }
  Components const parts = components(graph);
  EXPECT_EQ(parts.count(), 4U);
  for (std::uint32_t count : {1U, 2U, 4U}) {
    BlockFigures const figures = block_figures(graph, partition(graph, parts, count));
    EXPECT_EQ(figures.cut, 0U) << count;
    EXPECT_EQ(figures.balance, 1) << count;
    EXPECT_EQ(figures.depth, 1U) << count;
  }
}

// 0 and 3 in one block, 1 and 2 in the other: each waits for the other.
TEST(Blocks, ThatWaitForEachOtherHaveNoDepth) {
  TaskGraph graph;
  for (TaskId task = 0; task < 4; ++task) {
    TaskId const before = task - 1;
    graph.add(5, task == 0 ? std::span<TaskId const>() : std::span<TaskId const>(&before, 1));
  }
  Blocks const blocks{2, {0, 1, 1, 0}};
  BlockFigures const figures = block_figures(graph, blocks);
  EXPECT_EQ(figures.depth, std::nullopt);
  EXPECT_EQ(figures.hand_overs, 2U);
  EXPECT_EQ(span_of_blocks(graph, blocks, 7), 4 * 5 + 2 * 7);
  EXPECT_EQ(length_in_order(graph, blocks, 7), 4 * 5 + 2 * 7);
}

// Each block does one task after the other, and waits for what it needs: never shorter than its work, nor than the
// path.
TEST(Blocks, InTheOrderOfTheGraphTakeAsLongAsTheFullestAndAsTheLongestPath) {
  for_all_blocks([](TaskGraph const &graph, Components const &, Blocks const &blocks) {
    Time const work = std::accumulate(graph.duration.begin(), graph.duration.end(), Time{0});
    BlockFigures const figures = block_figures(graph, blocks);
    for (Time const hand_over : {0, 3}) {
      Time const length = length_in_order(graph, blocks, hand_over);
      EXPECT_GE(length, *std::ranges::max_element(figures.work));
      EXPECT_GE(length, span_of_blocks(graph, blocks, hand_over));
      EXPECT_LE(length, work + static_cast<Time>(figures.cut) * hand_over);
    }
  });
}

TEST(Blocks, InTheOrderOfTheGraphAThreadWaitsThoughItHasOtherWork) {
  TaskGraph graph; // 0 feeds 1; 2 waits for nothing, but its thread does 1 before
  TaskId const first = 0;
  graph.add(4, {});
  graph.add(1, std::span(&first, 1));
  graph.add(4, {});
  EXPECT_EQ(length_in_order(graph, {2, {0, 1, 1}}, 2), 4 + 2 + 1 + 4);
}

} // namespace
} // namespace symreal
