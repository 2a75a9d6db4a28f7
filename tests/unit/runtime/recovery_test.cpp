// What recovery makes of a graph computes the same, never takes more operations, and is always the same.
#include "engine/graph/graph_text.h"
#include "engine/graph/statistics.h"
#include "engine/graph/validate.h"
#include "engine/optimise/algebra/recovery.h"
#include "engine/optimise/passes/pass.h"

#include "graph_words.h"
#include "random_graph.h"

#include <cmath>
#include <gtest/gtest.h>

namespace symreal {
namespace {

using test::text;

// Per node the value in extended precision, and a bound on the error of computing it in double precision.
struct Extended {
  std::vector<long double> value, error;
};

Extended evaluate_extended(Graph const &graph, std::vector<double> const &x, std::vector<double> const &p) {
  Extended all;
  constexpr long double unit = 0x1p-52L;
  for (Node const &node : graph.nodes) {
    auto v = [&](std::size_t i) { return all.value[node.operand[i]]; };
    auto e = [&](std::size_t i) { return all.error[node.operand[i]]; };
    long double value = 0, error = 0;
    switch (node.op) {
    case Op::constant: value = node.value(), error = unit * std::fabs(value); break;
    case Op::input: value = x[node.slot()]; break;
    case Op::parameter: value = p[node.slot()]; break;
    case Op::add: value = v(0) + v(1), error = e(0) + e(1); break;
    case Op::sub: value = v(0) - v(1), error = e(0) + e(1); break;
    case Op::mul: value = v(0) * v(1), error = e(0) * std::fabs(v(1)) + e(1) * std::fabs(v(0)); break;
    case Op::div:
      value = v(0) / v(1);
      error = (e(0) + e(1) * std::fabs(value)) / std::fabs(v(1));
      break;
    case Op::neg: value = -v(0), error = e(0); break;
    case Op::sin: value = sinl(v(0)), error = e(0); break;
    case Op::cos: value = cosl(v(0)), error = e(0); break;
    case Op::atan: value = atanl(v(0)), error = e(0); break;
    case Op::tanh: value = tanhl(v(0)), error = e(0); break;
    case Op::lt: value = v(0) < v(1); break;
    case Op::select: value = v(0) != 0 ? v(1) : v(2), error = v(0) != 0 ? e(1) : e(2); break;
    default: ADD_FAILURE() << "an operation that random graphs have not"; break;
    }
    all.value.push_back(value);
    all.error.push_back(error + 4 * unit * std::fabs(value));
  }
  return all;
}

// Where a comparison could go either way nothing is compared.
bool is_clear(Graph const &graph, Extended const &all) {
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (node.op != Op::lt) continue;
    NodeId const a = node.operand[0], b = node.operand[1];
    if (std::fabs(all.value[a] - all.value[b]) <= 100 * (all.error[a] + all.error[b])) return false;
  }
  return true;
}

std::size_t cost(Graph const &graph) {
  OperationCounts const counts = statistics(graph).compute;
  return counts.arithmetic() + 3 * counts[Op::div];
}

int compared = 0;

void expect_same(Graph const &graph, Graph const &made, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  for (int sample = 0; sample < 8; ++sample) {
    std::vector<double> x(graph.input_count()), p(graph.parameter_count());
    for (double &value : x) value = uniform(random);
    for (double &value : p) value = uniform(random);
    Extended const before = evaluate_extended(graph, x, p), after = evaluate_extended(made, x, p);
    if (!is_clear(graph, before) || !is_clear(made, after)) continue;
    for (std::size_t k = 0; k < graph.results.size(); ++k) {
      NodeId const a = graph.results[k], b = made.results[k];
      long double const bound = 64 * (before.error[a] + after.error[b]);
      if (!(bound < 1)) continue; // nothing is left of it in double precision either
      EXPECT_LE(std::fabs(before.value[a] - after.value[b]), bound) << "seed " << seed << " output " << k;
      ++compared;
    }
  }
}

TEST(Recovery, RandomGraphsStayWhatTheyAre) {
  std::size_t before = 0, after = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Graph const graph = test::random_graph(seed, 40 + 4 * seed);
    Graph const made = algebra::recover_structure(graph, 1);
    ASSERT_EQ(find_violation(made), "") << seed;
    EXPECT_LE(cost(made), cost(graph)) << seed;
    expect_same(graph, made, seed);
    before += cost(graph), after += cost(made);
  }
  EXPECT_GT(compared, 500);
  EXPECT_LT(after, before * 9 / 10) << "there is much to find";
}

TEST(Recovery, IsTheSameEachTime) {
  Graph const graph = test::random_graph(7, 400);
  EXPECT_EQ(text(algebra::recover_structure(graph, 1)), text(algebra::recover_structure(graph, 1)));
}

TEST(Recovery, OtherModesAndNoEffortLeaveAGraphAsItIs) {
  Graph const graph = test::random_graph(3, 200);
  std::vector<std::string> const pass = {"recover"};
  for (PassSettings const &settings :
       {PassSettings(FloatingPoint::finite), PassSettings(FloatingPoint::strict), PassSettings(FloatingPoint::fast, 0)})
    EXPECT_EQ(text(run_passes(graph, pass, settings)), text(graph));
}

// No quotient and no square root that was not there.
TEST(Recovery, DividesByNothingNew) {
  for (std::uint64_t seed = 100; seed < 110; ++seed) {
    Graph const graph = test::random_graph(seed, 300);
    std::vector<std::string> const passes = default_passes();
    Graph const finite = run_passes(graph, passes, FloatingPoint::finite);
    Graph const fast = run_passes(graph, passes, {FloatingPoint::fast, 1});
    EXPECT_LE(statistics(fast).compute[Op::div], statistics(finite).compute[Op::div]) << seed;
    EXPECT_LE(cost(fast), cost(finite)) << seed;
  }
}

} // namespace
} // namespace symreal
