// The functions of numbers with as many bits as asked for.
#include "engine/graph/evaluate.h"
#include "engine/graph/extended.h"
#include "engine/graph/graph_text.h"
#include "tests/unit/runtime/operation_samples.h"
#include "verify/exact_errors.h"

#include <cmath>
#include <gtest/gtest.h>

namespace symreal::program {
namespace {

TEST(Multiprecision, EveryOperationIsThatOfLongDouble) {
  Multiprecision::set_bits(200);
  std::size_t compared = 0;
  for (OperationInfo const &row : detail::operation_table) {
    if (row.has(flag::OPAQUE | flag::WIDE | flag::TAKES_WIDE) || row.op == Op::nextafter) continue;
    for (auto const &[x, y, z] : test::samples(row, 50)) {
      auto const expected = static_cast<double>(evaluate_extended(row.op, x, y, z));
      if (std::isnan(expected)) continue;
      Multiprecision const exact = evaluate_exact(row.op, Multiprecision(x), Multiprecision(y), Multiprecision(z));
      EXPECT_LE(std::fabs(static_cast<double>(exact - Multiprecision(expected))), 0x1p-52 * std::fabs(expected))
          << row.name << " of " << x << ", " << y << ", " << z;
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
  Sample const sample{{2}, {}};
  std::vector<double> const values = evaluate(graph, sample.inputs, {}), original = {2.0 / 3},
                            code = {std::nextafter(2.0 / 3, 1)};
  EXPECT_TRUE(errors.compare(5, sample, values, original, code));
  EXPECT_FALSE(errors.compare(6, sample, values, original, original));
  ErrorsOfOutput const &told = errors.result().outputs[0];
  EXPECT_EQ(errors.result().samples, 2u);
  EXPECT_EQ(told.original_nearer, 1u); // it is rounded down by a third of its last place
  EXPECT_EQ(told.generated_nearer, 0u);
  EXPECT_EQ(told.worst_sample, 5u);
  EXPECT_NEAR(told.original, 0x1p-53 / 3, 1e-20);
  EXPECT_NEAR(told.generated, 0x1p-53 * 2 / 3, 1e-20);
}

// More bits take longer, so fewer samples are looked at.
TEST(ExactErrors, LeavesOutWhatTakesTooLong) {
  std::string body = "%1 = add %0 1\n";
  for (int k = 2; k < 200000; ++k) body += "%" + std::to_string(k) + " = add %" + std::to_string(k - 1) + " 1\n";
  Graph const graph = read(body + "result 0 %199999\n");
  ExactErrors errors(graph, most_exact_bits);
  Sample const sample{{1}, {}};
  std::vector<double> const y = {200000};
  EXPECT_FALSE(errors.compare(0, sample, evaluate(graph, sample.inputs, {}), y, y));
  EXPECT_EQ(errors.result().left_out, 1u);
  EXPECT_EQ(errors.result().samples, 0u);
}

// An integer of a number that double precision rounds up is the one below.
TEST(ExactErrors, ADecisionThatFallsOtherwiseIsCounted) {
  Graph const graph = read("%1 = sub 3 1e-17\n%2 = mul %1 %0\n%3 = int32 %2\nresult 0 %3\n");
  ExactErrors errors(graph, 256);
  Sample const sample{{1}, {}};
  std::vector<double> const y = {3};
  errors.compare(0, sample, evaluate(graph, sample.inputs, {}), y, y);
  EXPECT_EQ(errors.result().untold, 1u);
  EXPECT_EQ(errors.result().samples, 0u);
}

} // namespace
} // namespace symreal::program
