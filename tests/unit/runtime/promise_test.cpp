// The promises of the modes (docs/reference/floating-point.md), on random graphs of all operations on numbers: after
// all passes, strict gives the same bits at any operands, finite gives equal numbers where the premises hold. 10000
// graphs a mode, or as many as SYMREAL_RANDOM_GRAPHS says.
#include "engine/graph/evaluate.h"

#include "graph_words.h"
#include "promises.h"
#include "random_operations.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <iostream>
#include <limits>
#include <optional>
#include <random>

namespace symreal {
namespace {

using test::passed;
using test::text;

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
constexpr double corners[] = {0,       -0.0,  1,      -1,       2,  0.5,      -3,        0.1, 1e-310,
                              -5e-324, 1e300, -1e300, 0x1p-600, 10, infinity, -infinity, nan};

// The sign of a NaN that an operation makes is nobody's promise.
bool shows_sign_of_nan(Graph const &graph, std::vector<double> const &values) {
  for (Node const &node : graph.nodes)
    if (!is_leaf(node.op) && info(node.op).has(flag::ZERO_SIGN))
      for (std::size_t k = 0; k < arity(node.op); ++k)
        if (std::isnan(values[node.operand[k]])) return true;
  return false;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

// Compares all outputs of a random graph before and after the passes; counts what it compared.
void expect_promise(FloatingPoint mode, std::uint64_t seed, std::size_t &compared) {
  Graph const graph = test::RandomGraph(seed, corners).graph();
  std::optional<Graph> const optimised = passed(graph, mode);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-4, 4);
  auto operand = [&] { return random() % 3 == 0 ? uniform(random) : corners[random() % std::size(corners)]; };
  for (int sample = 0; sample < 12; ++sample) {
    double const x[] = {operand(), operand(), operand(), operand()}, p[] = {operand(), operand()};
    std::vector<double> const before = evaluate(graph, x, p);
    bool const applies =
        mode == FloatingPoint::strict ? !shows_sign_of_nan(graph, before) : check_premises(graph, before).hold();
    if (!applies) continue;
    std::size_t const failing = first_failing_guard(graph, before);
    bool const holds = failing == graph.guards.size();
    if (!optimised) {
      ASSERT_FALSE(holds) << "seed " << seed << '\n' << text(graph);
      continue;
    }
    Graph const &made = *optimised;
    std::vector<double> const after = evaluate(made, x, p);
    ASSERT_EQ(first_failing_guard(made, after) == made.guards.size(), holds) << "seed " << seed << '\n' << text(graph);
    for (std::size_t k = 0; holds && k < graph.results.size(); ++k, ++compared) {
      double const a = before[graph.results[k]], b = after[made.results[k]];
      bool const is_kept = mode == FloatingPoint::strict ? same_bits(a, b) : a == b;
      ASSERT_TRUE(is_kept) << "seed " << seed << ", output " << k << ": " << a << " became " << b << " at " << x[0]
                           << ' ' << x[1] << ' ' << x[2] << ' ' << x[3] << ", " << p[0] << ' ' << p[1] << '\n'
                           << text(graph) << text(made);
    }
  }
}

void expect_promise(FloatingPoint mode, std::size_t least) {
  std::size_t compared = 0;
  std::uint64_t const graphs = test::wanted_graphs(10000);
  for (std::uint64_t seed = 1; seed <= graphs && !testing::Test::HasFatalFailure(); ++seed)
    expect_promise(mode, seed, compared);
  EXPECT_GE(compared, least * graphs);
  testing::Test::RecordProperty("graphs", static_cast<int>(graphs));
  std::cout << graphs << " graphs, " << compared << " outputs compared\n";
}

TEST(Promise, StrictGivesTheSameBits) { expect_promise(FloatingPoint::strict, 10); }
TEST(Promise, FiniteGivesEqualNumbersUnderItsPremises) { expect_promise(FloatingPoint::finite, 1); }

} // namespace
} // namespace symreal
