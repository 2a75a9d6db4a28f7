#include "engine/analysis/levels/ready_tasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace symreal {
namespace {

// Beside a list that is searched from end to end. Ranges of times around powers of 64, where levels begin.
TEST(ReadyTasks, TheMostUrgentComesFirst) {
  for (Time const last : {0, 1, 63, 64, 65, 4095, 4096, 300'000}) {
    std::mt19937 random(static_cast<unsigned>(last) + 1);
    constexpr TaskId count = 500;
    ReadyTasks tasks(count, last);
    std::vector<Time> due(count), waiting;
    for (TaskId task = 0; task < count || !waiting.empty();) {
      ASSERT_EQ(tasks.empty(), waiting.empty());
      if (task < count && (waiting.empty() || random() % 3 != 0)) {
        due[task] = static_cast<Time>(random() % static_cast<unsigned>(last + 1));
        tasks.push(due[task], task);
        waiting.push_back(due[task++]);
      } else {
        auto const first = std::min_element(waiting.begin(), waiting.end());
        ASSERT_EQ(due[tasks.pop()], *first) << last;
        waiting.erase(first);
      }
    }
    EXPECT_TRUE(tasks.empty());
  }
}

} // namespace
} // namespace symreal
