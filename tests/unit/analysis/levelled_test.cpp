#include "engine/analysis/levels/levelled.h"

#include "random_tasks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace symreal {
namespace {

struct Case {
  explicit Case(unsigned seed) : graph(random_tasks(seed)) {}
  TaskGraph graph;
  Levels all = levels(graph);
  LevelProfile early = profile(graph, all.earliest, all.span), late = profile(graph, all.latest, all.span);
  LevelBounds bounds = LevelBounds(graph, all, early, late);
};

void expect_in_order(TaskGraph const &graph, Levelled const &found) {
  for (TaskId task = 0; task < graph.size(); ++task) {
    EXPECT_LE(0, found.start[task]);
    EXPECT_LE(found.start[task] + graph.duration[task], found.length);
    for (TaskId before : graph.predecessors(task))
      EXPECT_LE(found.start[before] + graph.duration[before], found.start[task]);
  }
  EXPECT_EQ(found.peak, peak(profile(graph, found.start, found.length)));
}

TEST(Levelled, ForTheSpanNoPeakIsHigherThanThoseOfTheLevels) {
  for (unsigned seed = 0; seed < random_graphs; ++seed) {
    SCOPED_TRACE(seed);
    Case const one(seed);
    Levelled const found = level_for_length(one.graph, one.all, one.bounds, one.all.span);
    expect_in_order(one.graph, found);
    EXPECT_LE(found.length, one.all.span);
    EXPECT_LE(found.peak, std::min(peak(one.early), peak(one.late)));
    EXPECT_GE(found.peak, one.bounds.units(one.all.span));
    for (TaskId task = 0; task < one.graph.size(); ++task) {
      EXPECT_LE(one.all.earliest[task], found.start[task]);
      EXPECT_LE(found.start[task], one.all.latest[task]);
    }
  }
}

TEST(Levelled, MoreTimeNeverNeedsMoreUnitsThanTheBoundAllows) {
  for (unsigned seed = 0; seed < random_graphs; ++seed) {
    SCOPED_TRACE(seed);
    Case const one(seed);
    for (Time const length : {one.all.span + 1, 2 * one.all.span, one.all.work + one.all.span}) {
      Levelled const found = level_for_length(one.graph, one.all, one.bounds, length);
      expect_in_order(one.graph, found);
      EXPECT_LE(found.length, length);
      EXPECT_GE(found.peak, one.bounds.units(length));
    }
    if (one.all.work > 0)
      EXPECT_EQ(level_for_length(one.graph, one.all, one.bounds, one.all.work + one.all.span).peak, 1U);
  }
}

TEST(Levelled, UnitsAreNeverExceededAndNoBoundIsBeaten) {
  for (unsigned seed = 0; seed < random_graphs; ++seed) {
    SCOPED_TRACE(seed);
    Case const one(seed);
    for (std::uint32_t const units : {1U, 2U, 3U, 8U, 100U}) {
      Levelled const found = level_for_units(one.graph, one.all, units);
      expect_in_order(one.graph, found);
      EXPECT_LE(found.peak, units);
      EXPECT_GE(found.length, one.bounds.length(units));
      EXPECT_GE(one.bounds.length(units), one.bounds.simple_length(units));
    }
    EXPECT_EQ(level_for_units(one.graph, one.all, 1).length, one.all.work);
    EXPECT_EQ(level_for_units(one.graph, one.all, 100).length, one.all.span);
  }
}

// Four tasks that may run at any time beside a chain of four.
TEST(Levelled, PeaksMoveIntoValleys) {
  TaskGraph graph;
  for (TaskId k = 0; k < 4; ++k) k == 0 ? graph.add(1, {}) : graph.add(1, std::array{k - 1});
  for (int k = 0; k < 4; ++k) graph.add(1, {});
  Levels const all = levels(graph);
  LevelProfile const early = profile(graph, all.earliest, 4), late = profile(graph, all.latest, 4);
  EXPECT_EQ(early, (LevelProfile{5, 1, 1, 1}));
  EXPECT_EQ(late, (LevelProfile{1, 1, 1, 5}));
  Levelled const found = level_for_length(graph, all, LevelBounds(graph, all, early, late), 4);
  EXPECT_EQ(profile(graph, found.start, 4), (LevelProfile{2, 2, 2, 2}));
}

} // namespace
} // namespace symreal
