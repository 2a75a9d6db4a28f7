#include "engine/analysis/costs/measuring.h"

#include <gtest/gtest.h>

namespace symreal {
namespace {

constexpr std::string_view measured =
    "processors 4 2\nhand_over 100.04\nbarrier 2 200.06\nbarrier 4 300\nwake 30000\nstart 20000\n";

TEST(ThreadCosts, AreReadBackFromTheFile) {
  auto const costs = measured_thread_costs(measured);
  ASSERT_TRUE(costs);
  Costs const read = read_costs(cost_file_text("- 1 1\n-wide 1 1\nadd 2 2\n", "", costs), "costs.json");
  ASSERT_TRUE(read.threads);
  EXPECT_EQ(read.threads->processors, 4U);
  EXPECT_EQ(read.threads->cores, 2U);
  EXPECT_EQ(read.threads->hand_over, 100);
  EXPECT_EQ(read.threads->wake, 30000);
  EXPECT_EQ(read.threads->start, 20000);
  EXPECT_EQ(read.threads->barrier(2), 200.1);
}

TEST(ThreadCosts, ABarrierOfAnotherNumberIsTheNextThatWasMeasured) {
  auto const costs = measured_thread_costs(measured);
  ASSERT_TRUE(costs);
  EXPECT_EQ(costs->barrier(3), 300);
  EXPECT_EQ(costs->barrier(100), 300);
}

TEST(ThreadCosts, OfOneProcessorAreNotMeasured) {
  auto const costs = measured_thread_costs("processors 1 1\n");
  ASSERT_TRUE(costs);
  EXPECT_FALSE(costs->is_measured());
  Costs const read = read_costs(cost_file_text("- 1 1\n-wide 1 1\nadd 2 2\n", "", costs), "costs.json");
  ASSERT_TRUE(read.threads);
  EXPECT_FALSE(read.threads->is_measured());
}

TEST(ThreadCosts, AnEarlierFileHasNone) {
  EXPECT_FALSE(read_costs(cost_file_text("- 1 1\n-wide 1 1\nadd 2 2\n", ""), "costs.json").threads);
}

TEST(ThreadCosts, OutputThatIsNotThatOfTheProgramIsNone) {
  for (char const *text : {"", "killed", "processors 2 2\n", "processors 2 2\nhand_over x\n",
                           "processors 2 2\nhand_over 100\nbarrier 2 200\nwake 0\nstart 1\n"})
    EXPECT_FALSE(measured_thread_costs(text)) << text;
}

} // namespace
} // namespace symreal
