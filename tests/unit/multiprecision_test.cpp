// The functions of numbers with as many bits as asked for.
#include "graph/extended.h"
#include "graph/graph_text.h"
#include "program/exact_errors.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace symreal::program {
namespace {

double operand_of(Domain domain, std::mt19937_64 &random) {
  double const x = std::uniform_real_distribution<double>(0.1, 0.9)(random);
  switch (domain) {
  case Domain::any: return random() % 2 == 0 ? 4 * x : -4 * x;
  case Domain::positive: return 4 * x;
  case Domain::unit: return random() % 2 == 0 ? x : -x;
  case Domain::above_one: return 1 + x;
  case Domain::integer: return std::trunc(100 * x);
  }
  return x;
}

TEST(Multiprecision, EveryOperationIsThatOfLongDouble) {
  Multiprecision::set_bits(200);
  std::mt19937_64 random(7);
  std::size_t compared = 0;
  for (OperationInfo const &row : detail::operation_table) {
    if (row.has(flag::OPAQUE | flag::WIDE | flag::TAKES_WIDE) || row.op == Op::nextafter) continue;
    for (int k = 0; k < 50; ++k) {
      double const x = operand_of(row.domain, random), y = operand_of(row.domain, random),
                   z = operand_of(row.domain, random);
      auto const exact =
          static_cast<double>(evaluate_exact(row.op, Multiprecision(x), Multiprecision(y), Multiprecision(z)) -
                              Multiprecision(static_cast<double>(evaluate_extended(row.op, x, y, z))));
      double const expected = static_cast<double>(evaluate_extended(row.op, x, y, z));
      if (std::isnan(expected)) continue;
      EXPECT_LE(std::fabs(exact), 0x1p-52 * std::fabs(expected)) << row.name << " of " << x << ", " << y << ", " << z;
      ++compared;
    }
  }
  EXPECT_GT(compared, 50u * 60);
}

TEST(Multiprecision, HasTheBits) {
  Multiprecision::set_bits(256);
  Multiprecision const two(2), root = sqrt(two), third = Multiprecision(1) / Multiprecision(3);
  EXPECT_LT(std::fabs(static_cast<double>(root * root - two)), 0x1p-253);
  EXPECT_LT(std::fabs(static_cast<double>(third * Multiprecision(3) - Multiprecision(1))), 0x1p-254);
  EXPECT_LT(std::fabs(static_cast<double>(sin(Multiprecision(1e22)) - Multiprecision(-0.8522008497671888))), 0x1p-53);
}

TEST(Multiprecision, NothingIsComparedWithWhatIsNoNumber) {
  Multiprecision const none = sqrt(Multiprecision(-1));
  EXPECT_FALSE(none < 0.0);
  EXPECT_FALSE(none >= 0.0);
  EXPECT_FALSE(none == none);
}

Graph read(std::string const &body) {
  return read_graph("symreal-graph 1\nkernel \"k\"\ninput \"x\"\noutput \"y\"\n%0 = input 0\n" + body, "test");
}

TEST(ExactErrors, TellsWhichIsNearer) {
  Graph const graph = read("%1 = div %0 3\nresult 0 %1\n");
  ExactErrors errors(graph, 256);
  std::vector<double> const x = {2}, original = {2.0 / 3}, code = {std::nextafter(2.0 / 3, 1)};
  EXPECT_TRUE(errors.compare(5, x, {}, original, code));
  EXPECT_FALSE(errors.compare(6, x, {}, original, original));
  ErrorsOfOutput const &told = errors.result().outputs[0];
  EXPECT_EQ(errors.result().samples, 2u);
  EXPECT_EQ(told.original_nearer, 1u);
  EXPECT_EQ(told.generated_nearer, 0u);
  EXPECT_EQ(told.worst_sample, 5u);
  EXPECT_NEAR(told.original, 0x1p-54 * 2 / 3, 1e-20); // 2/3 is rounded up by a third of its last place
  EXPECT_NEAR(told.generated - told.original, 0, 0x1p-53);
}

// An integer of a number that double precision rounds up is the one below.
TEST(ExactErrors, ADecisionThatFallsOtherwiseIsCounted) {
  Graph const graph = read("%1 = sub 3 1e-17\n%2 = mul %1 %0\n%3 = int32 %2\nresult 0 %3\n");
  ExactErrors errors(graph, 256);
  std::vector<double> const x = {1}, y = {3};
  errors.compare(0, x, {}, y, y);
  EXPECT_EQ(errors.result().untold, 1u);
  EXPECT_EQ(errors.result().samples, 0u);
}

} // namespace
} // namespace symreal::program
