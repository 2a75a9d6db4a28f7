// The promise of mode fast (docs/reference/floating-point.md), on random graphs: after all passes, at every effort, the
// same function of real numbers, with errors of rounding that are about those of the original, and never more to
// compute than the graph had or mode finite leaves. 2000 graphs at effort 0, or as many as SYMREAL_RANDOM_GRAPHS says;
// a third of that at effort 1, a two-hundredth at 2.
#include "engine/graph/evaluate.h"
#include "engine/optimise/algebra/recovery.h"

#include "graph_words.h"
#include "promises.h"
#include "random_graph.h"
#include "random_operations.h"
#include "rounding_bounds.h"

#include <gtest/gtest.h>
#include <iostream>
#include <optional>
#include <sstream>

namespace symreal {
namespace {

using test::Bounded;
using test::passed;
using test::text;

constexpr std::uint64_t usual_graphs = 2000;
constexpr double numbers[] = {0, 1, -1, 2, 0.5, -3, 0.1, 10, -0.25, 1e-3, 0.7};

struct Count {
  std::size_t compared = 0, farther = 0; // outputs, and of these those that rounding moves farther than the original's
};

Graph random_fast_graph(std::uint64_t seed) {
  if (seed % 2 == 0) return test::random_graph(seed, 20 + seed / 2 % 60);
  return test::RandomGraph(seed, numbers).graph();
}

double cost(Graph const &graph) { return algebra::cost_of(graph, usual_costs()); }

// Whether all guards hold; nothing where rounding may decide it.
std::optional<bool> guards_hold(Graph const &graph, std::vector<Bounded> const &values) {
  for (Guard const &guard : graph.guards) {
    if (values[guard.condition].error != 0) return {};
    if (values[guard.condition].value == 0) return false;
  }
  return true;
}

void compare(Graph const &graph, Graph const &made, double const (&x)[6], double const (&p)[2], std::string const &who,
             Count &count) {
  std::vector<double> const in_double = evaluate(graph, x, p);
  if (!check_premises(graph, in_double).hold()) return;
  std::vector<Bounded> const before = test::rounding_bounds(graph, x, p), after = test::rounding_bounds(made, x, p);
  std::optional<bool> const held = guards_hold(graph, before), holds = guards_hold(made, after);
  if (!held || !holds) return;
  ASSERT_EQ(*held, *holds) << who << text(graph) << text(made);
  if (!*held) return;
  std::vector<double> const computed = evaluate(made, x, p);
  for (std::size_t k = 0; k < graph.results.size(); ++k) {
    auto const [exact, original_error] = before[graph.results[k]];
    auto const [same, error] = after[made.results[k]];
    long double const size = std::max(std::fabs(exact), 1.0L), bound = 16 * (original_error + error);
    if (!std::isfinite(exact) || !(bound <= 1e-4L * size)) continue; // nothing is left of it in double precision either
    ++count.compared;
    auto const where = [&] {
      std::ostringstream out;
      out.precision(17);
      out << who << ", output " << k << ", at x = ";
      for (double const each : x) out << each << ' ';
      out << "p = " << p[0] << ' ' << p[1] << '\n' << text(graph) << text(made);
      return out.str();
    };
    ASSERT_LE(std::fabs(same - exact), bound) << exact << " became " << same << ' ' << where();
    ASSERT_LE(std::fabs(computed[made.results[k]] - exact), bound)
        << exact << " came out as " << computed[made.results[k]] << ' ' << where();
    if (error > 4 * original_error + 1e-9L * size) ++count.farther;
  }
}

void expect_promise(int effort, std::uint64_t seed, Count &count) {
  Graph const graph = random_fast_graph(seed);
  std::optional<Graph> const made = passed(graph, {FloatingPoint::fast, effort});
  std::optional<Graph> const finite = passed(graph, {FloatingPoint::finite});
  if (!made || !finite) return;
  std::string const who = "seed " + std::to_string(seed) + ", effort " + std::to_string(effort);
  EXPECT_LE(cost(*made), cost(graph)) << who << '\n' << text(graph) << text(*made);
  EXPECT_LE(cost(*made), cost(*finite)) << who << '\n' << text(graph) << text(*finite) << text(*made);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-2, 2);
  for (int sample = 0; sample < 6 && !testing::Test::HasFailure(); ++sample) {
    double x[6], p[2];
    for (double &each : x) each = uniform(random);
    for (double &each : p) each = uniform(random);
    compare(graph, *made, x, p, who, count);
  }
}

// Of the usual 2000 graphs so many, as the efforts take time.
void expect_promise(int effort, std::uint64_t usual) {
  Count count;
  std::uint64_t const graphs = test::wanted_graphs(usual_graphs) * usual / usual_graphs;
  for (std::uint64_t seed = 1; seed <= graphs && !testing::Test::HasFailure(); ++seed)
    expect_promise(effort, seed, count);
  EXPECT_GE(count.compared, 4 * graphs);
  EXPECT_LE(count.farther * 100, count.compared);
  std::cout << graphs << " graphs, " << count.compared << " outputs compared, " << count.farther
            << " of which rounding may move farther than the original's\n";
}

TEST(PromiseFast, RulesAlone) { expect_promise(0, usual_graphs); }
TEST(PromiseFast, TheLeastEffort) { expect_promise(1, 600); }
TEST(PromiseFast, TheUsualEffort) { expect_promise(2, 10); }

} // namespace
} // namespace symreal
