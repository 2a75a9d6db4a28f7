#include "engine/graph/node_table.h"
#include "engine/ops/operation.h"
#include "runtime/trace/decisions/known_outcomes.h"

#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace symreal {
namespace {

using trace::KnownOutcomes;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Op comparisons[] = {Op::lt, Op::le, Op::gt, Op::ge, Op::eq, Op::ne};

// Three numbers, and constants among them.
struct Numbers {
  NodeTable table;
  std::vector<NodeId> ids;

  Numbers() {
    for (std::uint32_t slot = 0; slot < 3; ++slot) ids.push_back(table.intern(Node::input(slot)));
    for (double value : {-0.0, 0.0, 1.0}) ids.push_back(table.constant(value));
  }
  NodeId compare(Op op, std::size_t a, std::size_t b) { return table.intern(table.operation(op, ids[a], ids[b])); }
};

struct Asked {
  Op op;
  std::size_t a, b;
};

// Every assignment of these values to the three numbers.
std::vector<std::array<double, 6>> assignments(std::vector<double> const &values) {
  std::vector<std::array<double, 6>> all;
  for (double x : values)
    for (double y : values)
      for (double z : values) all.push_back({x, y, z, -0.0, 0.0, 1.0});
  return all;
}

// What is known of a decision holds for all numbers for which the decisions before it fall as they did. `settled`
// counts.
void try_paths(bool with_nan, std::size_t &settled) {
  std::vector<double> values = {-1, -0.0, 0, 0.5, 1, 2};
  if (with_nan) values.push_back(nan);
  std::mt19937 random(1);
  for (int path = 0; path < 300; ++path) {
    Numbers numbers;
    KnownOutcomes known(with_nan);
    std::vector<std::array<double, 6>> possible = assignments(values);
    for (int step = 0; step < 8; ++step) {
      Asked const asked{comparisons[random() % 6], random() % 6, random() % 6};
      if (asked.a == asked.b) continue;
      bool const is_negated = random() % 4 == 0;
      NodeId condition = numbers.compare(asked.op, asked.a, asked.b);
      if (is_negated) condition = numbers.table.intern(numbers.table.operation(Op::logical_not, condition));
      auto const holds = [&](std::array<double, 6> const &one) {
        return (evaluate(asked.op, one[asked.a], one[asked.b], 0) != 0) != is_negated;
      };
      std::optional<bool> const outcome = known.outcome(numbers.table, condition);
      if (outcome) {
        ++settled;
        for (auto const &one : possible) ASSERT_EQ(holds(one), *outcome);
        continue;
      }
      bool const taken = holds(possible[random() % possible.size()]);
      known.add(numbers.table, condition, taken);
      std::erase_if(possible, [&](auto const &one) { return holds(one) != taken; });
      EXPECT_EQ(known.outcome(numbers.table, condition), taken);
    }
  }
}

TEST(KnownOutcomes, HoldForAllNumbersThatComeThisWay) {
  std::size_t finite = 0, with_nan = 0;
  try_paths(false, finite);
  try_paths(true, with_nan);
  EXPECT_GT(finite, with_nan);
  EXPECT_GT(with_nan, 300u);
}

TEST(KnownOutcomes, FollowAlongAChain) {
  Numbers numbers;
  KnownOutcomes known(false);
  known.add(numbers.table, numbers.compare(Op::lt, 0, 1), true);
  known.add(numbers.table, numbers.compare(Op::gt, 1, 2), false);
  EXPECT_EQ(known.outcome(numbers.table, numbers.compare(Op::ge, 0, 2)), false);
  EXPECT_EQ(known.outcome(numbers.table, numbers.compare(Op::ne, 2, 0)), true);
  EXPECT_EQ(known.outcome(numbers.table, numbers.compare(Op::eq, 1, 2)), std::nullopt);
}

TEST(KnownOutcomes, ConstantsHaveTheirOrder) {
  Numbers numbers;
  KnownOutcomes known(false);
  known.add(numbers.table, numbers.compare(Op::lt, 0, 4), true); // x < 0
  EXPECT_EQ(known.outcome(numbers.table, numbers.compare(Op::gt, 0, 5)), false);
  EXPECT_EQ(known.outcome(numbers.table, numbers.compare(Op::eq, 0, 3)), false);
}

TEST(KnownOutcomes, NaNStandsInNoOrder) {
  Numbers numbers;
  KnownOutcomes strict(true), finite(false);
  for (KnownOutcomes *known : {&strict, &finite}) known->add(numbers.table, numbers.compare(Op::lt, 0, 1), false);
  EXPECT_EQ(strict.outcome(numbers.table, numbers.compare(Op::ge, 0, 1)), std::nullopt);
  EXPECT_EQ(finite.outcome(numbers.table, numbers.compare(Op::ge, 0, 1)), true);
}

} // namespace
} // namespace symreal
