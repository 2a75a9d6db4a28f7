#include "engine/analysis/levels/levels.h"

#include "random_tasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace symreal {
namespace {

TEST(Levels, NoTaskBeginsBeforeThoseThatItNeedsHaveEnded) {
  for (unsigned seed = 0; seed < random_graphs; ++seed) {
    TaskGraph const graph = random_tasks(seed);
    Levels const all = levels(graph);
    for (TaskId task = 0; task < graph.size(); ++task) {
      EXPECT_LE(0, all.earliest[task]) << seed;
      EXPECT_LE(all.earliest[task], all.latest[task]) << seed;
      EXPECT_LE(all.latest[task] + graph.duration[task], all.span) << seed;
      for (TaskId before : graph.predecessors(task)) {
        EXPECT_LE(all.earliest[before] + graph.duration[before], all.earliest[task]) << seed;
        EXPECT_LE(all.latest[before] + graph.duration[before], all.latest[task]) << seed;
      }
    }
  }
}

TEST(Levels, TheCriticalPathHasNoSlackAndIsAsLongAsTheSpan) {
  for (unsigned seed = 0; seed < random_graphs; ++seed) {
    TaskGraph const graph = random_tasks(seed);
    Levels const all = levels(graph);
    std::vector<TaskId> const path = critical_path(graph, all);
    Time length = 0;
    for (std::size_t k = 0; k < path.size(); ++k) {
      EXPECT_EQ(all.slack(path[k]), 0) << seed;
      EXPECT_EQ(all.earliest[path[k]], length) << seed;
      length += graph.duration[path[k]];
      if (k == 0) continue;
      std::span<TaskId const> const before = graph.predecessors(path[k]);
      EXPECT_NE(std::ranges::find(before, path[k - 1]), before.end()) << seed;
    }
    EXPECT_EQ(length, all.span) << seed;
  }
}

TEST(Levels, EveryProfileHoldsAllTheWork) {
  for (unsigned seed = 0; seed < random_graphs; ++seed) {
    TaskGraph const graph = random_tasks(seed);
    Levels const all = levels(graph);
    for (std::vector<Time> const *start : {&all.earliest, &all.latest}) {
      LevelProfile const counts = profile(graph, *start, all.span);
      EXPECT_EQ(counts.size(), static_cast<std::size_t>(all.span)) << seed;
      EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), Time{0}), all.work) << seed;
    }
  }
}

TEST(Levels, NothingIsNoWork) {
  Levels const none = levels({});
  EXPECT_EQ(none.span, 0);
  EXPECT_EQ(none.parallelism(), 0);
  EXPECT_TRUE(critical_path({}, none).empty());
  EXPECT_EQ(peak(profile({}, {}, 0)), 0U);
}

} // namespace
} // namespace symreal
