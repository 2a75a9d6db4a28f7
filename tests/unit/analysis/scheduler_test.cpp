#include "engine/analysis/scheduling/scheduler.h"

#include "exhaustive.h"
#include "random_graphs.h"

#include <gtest/gtest.h>

namespace symreal {
namespace {

void expect_sound(TaskGraph const &graph, Units const &units, Solution const &solution) {
  EXPECT_EQ(fault(graph, units, solution.timetable), std::nullopt);
  EXPECT_EQ(length(graph, solution.timetable.start), solution.length);
  EXPECT_LE(solution.bounds.best(), solution.at_least);
  EXPECT_LE(solution.at_least, solution.length);
}

TEST(Scheduler, finds_the_optimum_of_small_graphs_and_proves_it) {
  Random random(1);
  for (unsigned i = 0; i < 200; ++i) {
    TaskGraph const graph = random_graph({TaskId(4 + i % 6), 10 + 10 * (i % 4), 5, 1, i % 3 == 0}, random);
    Units const units{{1 + i % 4}};
    Solution const solution = schedule_tasks(graph, units, {});
    expect_sound(graph, units, solution);
    EXPECT_TRUE(solution.is_optimal());
    EXPECT_EQ(solution.length, EveryStep(graph, units).shortest()) << "graph " << i;
  }
}

TEST(Scheduler, finds_the_optimum_where_tasks_are_of_kinds) {
  Random random(2);
  for (unsigned i = 0; i < 200; ++i) {
    TaskGraph const graph = random_graph({TaskId(5 + i % 5), 15 + 10 * (i % 3), 4, 2, i % 2 == 0}, random);
    Units const units{{1 + i % 2, 1 + i % 3}};
    Solution const solution = schedule_tasks(graph, units, {});
    expect_sound(graph, units, solution);
    EXPECT_TRUE(solution.is_optimal());
    EXPECT_EQ(solution.length, EveryStep(graph, units).shortest()) << "graph " << i;
  }
}

TEST(Scheduler, finds_the_optimum_where_communication_takes_time) {
  Random random(3);
  for (unsigned i = 0; i < 150; ++i) {
    TaskGraph const graph = random_graph({TaskId(4 + i % 3), 20 + 15 * (i % 3), 4, 1 + i % 2, i % 3 == 0}, random);
    Units const units{i % 2 == 0 ? std::vector<unsigned>{2 + i % 2} : std::vector<unsigned>{2, 1}, 1 + Time(i % 4)};
    Solution const solution = schedule_tasks(graph, units, {});
    expect_sound(graph, units, solution);
    EXPECT_TRUE(solution.is_optimal());
    EXPECT_EQ(solution.length, EveryOrder(graph, units).shortest()) << "graph " << i;
  }
}

TEST(Scheduler, makes_timetables_that_can_be_done_of_graphs_of_any_size) {
  Random random(4);
  for (TaskId tasks : {1u, 2u, 50u, 65u, 300u, 1000u})
    for (Time communication : {0, 3})
      for (unsigned level : {0u, 1u}) {
        TaskGraph const graph = random_graph({tasks, 300 / (tasks + 10), 20, 1 + tasks % 2, true}, random);
        Units const units{{3, 2}, communication};
        expect_sound(graph, units, schedule_tasks(graph, units, {level, 7}));
        TaskGraph const layers = layered_graph(tasks / 8 + 1, 8, 10, random);
        expect_sound(layers, {{5}, communication}, schedule_tasks(layers, {{5}, communication}, {level, 7}));
      }
}

TEST(Scheduler, comes_close_to_the_bound_of_layered_graphs) {
  Random random(5);
  double gaps = 0;
  for (unsigned i = 0; i < 20; ++i) {
    TaskGraph const graph = layered_graph(20, 8, 10, random);
    Solution const solution = schedule_tasks(graph, {{4 + i % 5}}, {});
    gaps += double(solution.length - solution.at_least) / double(solution.at_least);
  }
  EXPECT_LT(gaps / 20, 0.01);
}

TEST(Scheduler, needs_no_longer_with_more_effort) {
  Random random(6);
  bool is_ever_shorter = false;
  for (unsigned i = 0; i < 30; ++i) {
    TaskGraph const graph = layered_graph(6, 6, 30, random);
    Time const lists = schedule_tasks(graph, {{4}}, {0, 1}).length, more = schedule_tasks(graph, {{4}}, {}).length;
    EXPECT_LE(more, lists);
    is_ever_shorter |= more < lists;
  }
  EXPECT_TRUE(is_ever_shorter);
}

TEST(Scheduler, gives_the_same_timetable_for_the_same_seed) {
  Random random(7);
  TaskGraph const graph = layered_graph(30, 7, 30, random);
  for (Time communication : {0, 5}) {
    Solution const a = schedule_tasks(graph, {{4}, communication}, {1, 5});
    Solution const b = schedule_tasks(graph, {{4}, communication}, {1, 5});
    EXPECT_EQ(a.timetable.start, b.timetable.start);
    EXPECT_EQ(a.timetable.unit, b.timetable.unit);
  }
}

TEST(Scheduler, schedules_nothing_in_no_time) {
  Solution const solution = schedule_tasks({}, {{2}, 1}, {});
  EXPECT_EQ(solution.length, 0);
  EXPECT_EQ(schedule_tasks({}, {{2}}, {}).length, 0);
}

} // namespace
} // namespace symreal
