#include "engine/support/progress.h"

#include <gtest/gtest.h>
#include <optional>
#include <thread>
#include <vector>

namespace symreal {
namespace {

TEST(Progress, SaysWhatIsCountedTheOutermostFirst) {
  EXPECT_EQ(Progress::now(), "");
  std::optional<Progress> passes(std::in_place, "passes", 12);
  passes->add();
  EXPECT_EQ(Progress::now(), "1 of 12 passes");
  Progress paths("paths");
  paths.add(40);
  EXPECT_EQ(Progress::now(), "1 of 12 passes, 40 paths");
  passes.reset(); // in another order than they began
  EXPECT_EQ(Progress::now(), "40 paths");
}

TEST(Progress, CountsWhatSeveralThreadsDo) {
  Progress objects("objects", 4000);
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < 4; ++k)
      threads.emplace_back([&] {
        for (int done = 0; done < 1000; ++done) objects.add();
      });
  }
  EXPECT_EQ(Progress::now(), "4000 of 4000 objects");
}

} // namespace
} // namespace symreal
