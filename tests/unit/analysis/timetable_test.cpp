#include "engine/analysis/scheduling/network.h"
#include "engine/analysis/scheduling/timetable.h"

#include <gtest/gtest.h>

namespace symreal {
namespace {

// Two tasks, and one that waits for both.
TaskGraph join() {
  TaskGraph graph;
  std::vector<TaskId> const both = {0, 1};
  graph.add(2, {});
  graph.add(3, {});
  graph.add(1, both);
  return graph;
}

TEST(Timetable, has_no_fault_when_it_can_be_done) {
  EXPECT_EQ(fault(join(), {{2}}, {{0, 0, 3}, {0, 1, 1}}), std::nullopt);
  EXPECT_EQ(fault(join(), {{2}, 5}, {{0, 2, 5}, {0, 0, 0}}), std::nullopt);
}

TEST(Timetable, says_what_is_wrong) {
  TaskGraph const graph = join();
  EXPECT_EQ(fault(graph, {{2}}, {{0, 0}, {0, 1}}), "tasks are missing");
  EXPECT_EQ(fault(graph, {{2}}, {{-1, 0, 3}, {0, 1, 1}}), "task 0 begins before time 0");
  EXPECT_EQ(fault(graph, {{2}}, {{0, 0, 3}, {0, 2, 1}}), "task 1 needs a unit of its kind");
  EXPECT_EQ(fault(graph, {{2}}, {{0, 0, 2}, {0, 1, 1}}), "task 2 begins before it has what task 1 computes");
  EXPECT_EQ(fault(graph, {{2}}, {{0, 1, 4}, {0, 0, 0}}), "task 0 and task 1 overlap on one unit");
  EXPECT_EQ(fault(graph, {{2}, 2}, {{0, 0, 3}, {0, 1, 1}}), "task 2 begins before it has what task 0 computes");
}

TEST(Timetable, keeps_kinds_apart) {
  TaskGraph graph = join();
  graph.kind = {0, 1, 1};
  EXPECT_EQ(fault(graph, {{1, 1}}, {{0, 0, 3}, {0, 1, 1}}), std::nullopt);
  EXPECT_EQ(fault(graph, {{1, 1}}, {{0, 0, 3}, {0, 1, 0}}), "task 2 needs a unit of its kind");
  EXPECT_EQ(assign_units(graph, {{1, 1}}, {0, 0, 3}).unit, (std::vector<std::uint32_t>{0, 1, 1}));
}

TEST(Timetable, pays_no_communication_to_dummies) {
  TaskGraph graph;
  std::vector<TaskId> const first = {0}, both = {1, 2};
  graph.add(0, {});
  graph.add(2, first);
  graph.add(2, first);
  graph.add(0, both);
  EXPECT_EQ(fault(graph, {{2}, 9}, {{0, 0, 0, 2}, {0, 0, 1, 0}}), std::nullopt);
}

TEST(Parts, are_cut_where_all_of_one_precedes_all_of_the_next) {
  TaskGraph graph;
  std::vector<TaskId> const first = {0}, two = {1, 2}, third = {3};
  graph.add(1, {});
  graph.add(1, first);
  graph.add(1, first);
  graph.add(1, two);
  graph.add(1, two);
  graph.add(1, third); // may begin before 4 ends
  using Parts = std::vector<std::vector<TaskId>>;
  EXPECT_EQ(chain_of_parts(make_network(graph)), (Parts{{0}, {1, 2}, {3, 4, 5}}));
  TaskGraph const part = part_graph(graph, {3, 4, 5});
  EXPECT_EQ(part.size(), 3u);
  EXPECT_EQ(part.predecessor, (std::vector<TaskId>{0}));
}

} // namespace
} // namespace symreal
