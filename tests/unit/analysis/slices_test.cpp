#include "engine/analysis/sharing/sharing.h"

#include "random_tasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace symreal {
namespace {

StatementTasks with_latency(TaskGraph tasks) {
  StatementTasks result{std::move(tasks), {}, {}};
  result.latency = result.tasks.duration;
  result.is_result.assign(result.tasks.size(), 0);
  return result;
}

std::vector<TaskId> in_order(StatementTasks const &statements) {
  std::vector<TaskId> order(statements.tasks.size());
  std::iota(order.begin(), order.end(), TaskId{0});
  return order;
}

// How long it takes: the slowest thread of each stage, and the meetings of those that are shared.
Time length(StatementTasks const &statements, std::vector<Share> const &shares, Time meeting) {
  std::map<std::uint32_t, std::map<std::uint32_t, Time>> work;
  for (TaskId task = 0; task < shares.size(); ++task)
    work[shares[task].stage][shares[task].thread] += statements.tasks.duration[task];
  Time sum = 0;
  for (auto const &[stage, threads] : work)
    sum += std::ranges::max_element(threads, {}, [](auto const &one) { return one.second; })->second +
           (threads.size() > 1 ? meeting : 0);
  return sum;
}

TEST(Slices, NothingIsComputedBeforeOrBesideWhatItNeeds) {
  for (unsigned seed = 0; seed < 60; ++seed)
    for (unsigned threads : {2U, 3U, 8U})
      for (Time meeting : {0, 1, 10, 1000}) {
        SCOPED_TRACE(testing::Message() << "graph " << seed << ", " << threads << " threads, " << meeting);
        StatementTasks const statements = with_latency(random_tasks(seed));
        std::vector<Share> const shares = sliced(statements, in_order(statements), threads, meeting);
        ASSERT_EQ(shares.size(), statements.tasks.size());
        for (TaskId task = 0; task < shares.size(); ++task) {
          ASSERT_LT(shares[task].thread, threads);
          for (TaskId before : statements.tasks.predecessors(task))
            EXPECT_TRUE(shares[before].stage < shares[task].stage ||
                        (shares[before].stage == shares[task].stage && shares[before].thread == shares[task].thread));
        }
      }
}

TEST(Slices, TakeNoLongerThanOneThread) {
  for (unsigned seed = 0; seed < 60; ++seed)
    for (Time meeting : {0, 5, 1000}) {
      StatementTasks const statements = with_latency(random_tasks(seed));
      Time const work = std::accumulate(statements.tasks.duration.begin(), statements.tasks.duration.end(), Time{0});
      EXPECT_LE(length(statements, sliced(statements, in_order(statements), 2, meeting), meeting), work);
    }
}

TEST(Slices, WhatIsDearToShareIsOneStageOfOneThread) {
  StatementTasks const statements = with_latency(random_tasks(3));
  for (Share const &share : sliced(statements, in_order(statements), 4, 1'000'000'000)) {
    EXPECT_EQ(share.stage, 0U);
    EXPECT_EQ(share.thread, 0U);
  }
}

TEST(Slices, ABeginningAndAnEndAreOneThreads) {
  TaskGraph tasks;
  tasks.add(3, {});
  std::vector<TaskId> ends;
  for (int branch = 0; branch < 2; ++branch)
    for (int k = 0; k < 10; ++k) {
      TaskId const before = k == 0 ? 0 : static_cast<TaskId>(tasks.size() - 1);
      tasks.add(10, {&before, 1});
      if (k == 9) ends.push_back(static_cast<TaskId>(tasks.size() - 1));
    }
  tasks.add(3, ends);
  StatementTasks const statements = with_latency(tasks);
  std::vector<Share> const shares = sliced(statements, in_order(statements), 2, 20);
  EXPECT_EQ(length(statements, shares, 20), 3 + 20 + 100 + 3);
  EXPECT_EQ(shares.front().stage, 0U);
  EXPECT_EQ(shares.back().stage, 2U);
  EXPECT_NE(shares[1].thread, shares[11].thread);
}

} // namespace
} // namespace symreal
