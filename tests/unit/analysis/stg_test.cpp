#include "engine/analysis/tasks/stg.h"

#include "engine/diagnostics/diagnostic.h"
#include "random_graphs.h"

#include <gtest/gtest.h>
#include <sstream>

namespace symreal {
namespace {

std::string written(TaskGraph const &graph, std::vector<std::uint64_t> const &id) {
  std::ostringstream text;
  write_stg(text, graph, id);
  return text.str();
}

constexpr char const *rows = "0 0 0\n1 4 1 0\n2 3 1 0\n3 0 2 1 2\n";

TEST(Stg, counts_the_dummies_or_not) {
  for (char const *count : {"2\n", "3\n", "4\n", "4 16\n"}) {
    StgTasks const read = read_stg(std::string(count) + rows, "f.stg");
    EXPECT_EQ(read.tasks.duration, (std::vector<Time>{0, 4, 3, 0}));
    EXPECT_EQ(read.tasks.predecessor, (std::vector<TaskId>{0, 0, 1, 2}));
    EXPECT_EQ(written(read.tasks, read.id), std::string("2\n") + rows);
  }
  EXPECT_THROW(read_stg(std::string("4 16 1\n") + rows, "f.stg"), DiagnosticError);
  EXPECT_THROW(read_stg(std::string("1\n") + rows, "f.stg"), DiagnosticError);
}

TEST(Stg, sorts_tasks_and_keeps_their_ids) {
  StgTasks const read = read_stg("3 # tasks\n# a comment\n70 5 2 9 8\n\n9 1 0\n  8 2 1 9\r\n", "f.stg");
  EXPECT_EQ(read.id, (std::vector<std::uint64_t>{9, 8, 70}));
  EXPECT_EQ(read.tasks.duration, (std::vector<Time>{1, 2, 5}));
  EXPECT_EQ(read.tasks.predecessor, (std::vector<TaskId>{0, 0, 1}));
}

TEST(Stg, reads_what_it_writes) {
  Random random(1);
  for (TaskId tasks = 0; tasks < 40; ++tasks) {
    TaskGraph const graph = random_graph({tasks, 20, 9, 1, true}, random);
    StgTasks const read = read_stg(written(graph, {}), "f.stg");
    bool const added = read.tasks.size() == tasks + 2;
    ASSERT_TRUE(added || read.tasks.size() == tasks);
    // With the dummies it is written as it is.
    EXPECT_EQ(written(read.tasks, read.id), written(graph, {}));
    for (TaskId task = 0; task < tasks; ++task) EXPECT_EQ(read.tasks.duration[task + added], graph.duration[task]);
    std::size_t inner = 0;
    for (TaskId task = added; task < tasks + added; ++task)
      for (TaskId before : read.tasks.predecessors(task)) inner += !added || before != 0;
    EXPECT_EQ(inner, graph.predecessor.size());
  }
}

} // namespace
} // namespace symreal
