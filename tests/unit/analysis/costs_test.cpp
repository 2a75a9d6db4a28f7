#include "engine/analysis/costs/measuring.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace symreal {
namespace {

std::size_t row(Op op) { return static_cast<std::size_t>(op); }

// What the measuring program prints where each operation takes two nanoseconds more than its link.
std::string measured() {
  std::string text = "- 3 1\n-wide 4 2\n";
  for (OperationInfo const &one : operations())
    if (one.form != Form::external)
      text += one.has(flag::WIDE) && one.has(flag::TAKES_WIDE) ? fmt::format("{} 6 2.5\n", one.name)
                                                               : fmt::format("{} 5 1.5\n", one.name);
  return text;
}

TEST(Costs, WhatTheLinkTakesIsSubtracted) {
  Costs const costs = read_costs(cost_file_text(measured(), "some compiler"), "costs.json");
  for (Op const op : {Op::add, Op::sin, Op::wide_mul, Op::select}) {
    EXPECT_EQ(costs.latency[row(op)], 20);
    EXPECT_EQ(costs.throughput[row(op)], 0.5);
  }
}

TEST(Costs, WhatCostsNothingInTheTableCostsNothing) {
  Costs const costs = read_costs(cost_file_text(measured(), ""), "costs.json");
  EXPECT_EQ(costs.latency[row(Op::neg)], 0);
  EXPECT_EQ(costs.throughput[row(Op::neg)], 0);
}

TEST(Costs, CallsCostWhatTheTableSaysAgainstAnAddition) {
  Costs const costs = read_costs(cost_file_text(measured(), ""), "costs.json");
  EXPECT_EQ(costs.latency[row(Op::call)], 20 * table_costs()[row(Op::call)]);
}

TEST(Costs, EveryOperationIsKnown) {
  Costs const costs = read_costs(cost_file_text(measured(), ""), "costs.json");
  for (OperationInfo const &one : operations()) EXPECT_TRUE(costs.is_known[row(one.op)]) << one.name;
}

TEST(Costs, OutputThatIsNotThatOfTheProgramGivesNoFile) {
  EXPECT_EQ(cost_file_text("", ""), "");
  EXPECT_EQ(cost_file_text("- 1 1\nadd 1 1\n", ""), "");
  EXPECT_EQ(cost_file_text("killed", ""), "");
}

TEST(Costs, EveryOperationWithAFormInCIsMeasured) {
  std::string const program = measuring_program();
  for (OperationInfo const &one : operations())
    EXPECT_EQ(program.find(fmt::format("{{\"{}\", one_", one.name)) != program.npos, one.form != Form::external)
        << one.name;
}

} // namespace
} // namespace symreal
