#include "engine/analysis/scheduling/exact.h"

#include "engine/analysis/scheduling/bounds.h"
#include "engine/analysis/scheduling/communicating.h"
#include "engine/analysis/scheduling/improvement.h"
#include "exhaustive.h"
#include "random_graphs.h"

#include <gtest/gtest.h>
#include <numeric>

namespace symreal {
namespace {

constexpr std::uint64_t no_limit = ~std::uint64_t{0};

Time all_work(TaskGraph const &graph) { return std::accumulate(graph.duration.begin(), graph.duration.end(), Time{0}); }

// Without a timetable to begin with, and without a length that is enough: the search must look everywhere.
TEST(ExactSearch, finds_what_trying_everything_finds) {
  Random random(11);
  for (unsigned i = 0; i < 300; ++i) {
    TaskGraph const graph = random_graph({TaskId(4 + i % 5), 5 + 10 * (i % 4), 5, 1 + i % 2, i % 5 == 0}, random);
    Units const units{i % 2 == 0 ? std::vector<unsigned>{1 + i % 4} : std::vector<unsigned>{1 + i % 3, 2}};
    Network const network = make_network(graph);
    ExactResult const result =
        search_exactly(network, units, windows(network, units), all_work(graph) + 1, 0, no_limit);
    ASSERT_TRUE(result.is_complete && !result.start.empty()) << "graph " << i;
    EXPECT_EQ(length(graph, result.start), EveryStep(graph, units).shortest()) << "graph " << i;
    EXPECT_EQ(fault(graph, units, assign_units(graph, units, result.start)), std::nullopt);
  }
}

TEST(ExactSearch, finds_what_trying_everything_finds_with_communication) {
  Random random(12);
  for (unsigned i = 0; i < 150; ++i) {
    TaskGraph const graph = random_graph({TaskId(3 + i % 4), 20 + 15 * (i % 3), 4, 1 + i % 2, i % 5 == 0}, random);
    Units const units{i % 2 == 0 ? std::vector<unsigned>{2 + i % 2} : std::vector<unsigned>{2, 1}, 1 + Time(i % 4)};
    Network const network = make_network(graph);
    ExactTimetable const result =
        search_communicating(network, units, dummies(graph), windows(network, units).tail,
                             all_work(graph) + units.communication * Time(graph.size()) + 1, 0, no_limit);
    ASSERT_TRUE(result.is_complete && !result.timetable.start.empty()) << "graph " << i;
    EXPECT_EQ(length(graph, result.timetable.start), EveryOrder(graph, units).shortest()) << "graph " << i;
    EXPECT_EQ(fault(graph, units, result.timetable), std::nullopt);
  }
}

TEST(ExactSearch, finds_nothing_shorter_than_a_bound_that_a_list_reaches) {
  Random random(13);
  unsigned reached = 0, shorter = 0;
  for (unsigned i = 0; i < 60; ++i) {
    TaskGraph const graph = layered_graph(5, 3 + i % 3, 10, random);
    Units const units{{2 + i % 2}};
    Network const network = make_network(graph);
    Windows const window = windows(network, units);
    Time const bound = bounds(network, units, window).best();
    Improvement lists(network, units, bound);
    lists.try_one_list();
    ExactResult const result = search_exactly(network, units, window, lists.length(), 0, 200'000);
    if (!result.start.empty()) {
      EXPECT_GE(length(graph, result.start), bound);
      EXPECT_LT(length(graph, result.start), lists.length());
      ++shorter;
    }
    if (lists.is_enough()) {
      EXPECT_TRUE(result.start.empty());
      ++reached;
    }
  }
  EXPECT_GT(reached, 0u);
  EXPECT_GT(shorter, 0u);
}

TEST(ExactSearch, says_when_it_has_not_looked_everywhere) {
  Random random(14);
  TaskGraph const graph = random_graph({40, 2, 97}, random);
  Units const units{{5}};
  Network const network = make_network(graph);
  EXPECT_FALSE(search_exactly(network, units, windows(network, units), all_work(graph), 0, 1000).is_complete);
}

} // namespace
} // namespace symreal
