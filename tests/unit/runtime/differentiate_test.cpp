#include "engine/optimise/differentiate/differentiate.h"

#include "engine/graph/evaluate.h"
#include "engine/graph/extended.h"
#include "engine/graph/graph_text.h"
#include "engine/graph/statistics.h"
#include "engine/graph/validate.h"
#include "engine/optimise/differentiate/differences.h"
#include "engine/optimise/differentiate/dual_numbers.h"
#include "engine/optimise/differentiate/rules.h"
#include "operation_samples.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace symreal {
namespace {

std::vector<DerivativeWish> wishes(std::vector<std::string> const &texts) {
  std::vector<DerivativeWish> result;
  for (std::string const &text : texts) result.push_back({text, {}});
  return result;
}

Graph with(Graph graph, std::vector<std::string> const &requests) {
  Graph result = differentiate(std::move(graph), wishes(requests), [](Diagnostic const &) {});
  EXPECT_EQ(find_violation(result), "");
  return result;
}

// A function of x[3], as lines from %3 on; the last is the result.
Graph function(std::string const &lines, std::string const &result) {
  return read_graph("symreal-graph 1\nkernel \"k\"\ninput \"x\" [3]\noutput \"y\"\n%0 = input 0\n%1 = input 1\n"
                    "%2 = input 2\n" +
                        lines + "result 0 " + result + "\n",
                    "test");
}

std::vector<double> outputs(Graph const &graph, std::vector<double> const &inputs) {
  return evaluate_sample(graph, inputs, {}).outputs;
}

bool has_formula(OperationInfo const &row) {
  for (std::size_t i = 0; i < row.arity; ++i)
    if (slope_of(row.op, i) == Slope::formula) return true;
  return false;
}

TEST(Differentiate, EachRowIsAsItsDifferences) {
  for (OperationInfo const &row : operations()) {
    if (!has_formula(row)) continue;
    std::size_t next = 3;
    std::string const lines = test::lines_on_numbers(row, 0, next);
    Graph const graph = function(lines, "%" + std::to_string(next - 1));
    std::vector<std::string> const request = {"jacobian(y, x)", "hessian(y, x)"};
    Differences const differences(graph, wishes(request));
    if (!differences.obstacle().empty()) {
      EXPECT_TRUE(row.op == Op::f32 || row.op == Op::nextafter) << row.name;
      continue;
    }
    Graph const both = with(graph, request);
    std::size_t compared = 0;
    for (auto const &x : test::samples(row, 40)) {
      std::vector<double> const found = outputs(both, {x.begin(), x.end()});
      std::vector<SharpNumber> const expected = differences.at(x, {}, 1e-9);
      ASSERT_EQ(expected.size() + 1, found.size());
      for (std::size_t k = 0; k < expected.size(); ++k) {
        if (!expected[k]) continue;
        auto const value = static_cast<double>(*expected[k]);
        EXPECT_NEAR(found[k + 1], value, 1e-9 * (1 + std::abs(value))) << row.name << " element " << k;
        ++compared;
      }
    }
    EXPECT_GT(compared, 100u) << row.name;
  }
}

// Where rounding swallows each step, equal numbers on both sides are no derivative of 0.
TEST(Differentiate, DifferencesKnowWhatRoundingHides) {
  for (char const *const lines : {"%3 = add %0 1e22\n%4 = mul %3 %1\n", "%3 = add %0 1e22\n%4 = abs %3\n"}) {
    Graph const graph = function(lines, "%4");
    std::vector<std::string> const request = {"gradient(y)"};
    std::vector<double> const x = {0.5, 0.25, 0};
    EXPECT_FALSE(Differences(graph, wishes(request)).at(x, {}, 1e-9)[0]) << lines;
  }
}

// Steps that leap over whole periods of a sine agree with each other, and smaller ones do not bear them out.
TEST(Differentiate, DifferencesLeapOverNoPeriods) {
  std::vector<std::string> const request = {"gradient(y)", "hessian(y, x)"};
  Graph const graph = function("%3 = mul %0 100\n%4 = sin %3\n%5 = mul %4 1e-9\n", "%5");
  for (double const x : {1e8, -54321987.25, 7e7}) {
    std::vector<double> const at = {x, 0.5, 0.25}, found = outputs(with(graph, request), at);
    std::vector<SharpNumber> const sharp = Differences(graph, wishes(request)).at(at, {}, 1e-9);
    for (std::size_t k = 0; k < sharp.size(); ++k)
      if (sharp[k]) EXPECT_NEAR(found[1 + k], static_cast<double>(*sharp[k]), 1e-9) << " at " << x;
  }
}

// Dual numbers are there everywhere, corners included, and say what the formulas say.
TEST(Differentiate, DualNumbersAreAsFormulas) {
  std::vector<std::string> const request = {"jacobian(y, x)", "hessian(y, x)", "hessian(y, x, weighted)", "jvp(y, x)",
                                            "vjp(y, x)"};
  for (OperationInfo const &row : operations()) {
    if (!has_formula(row) || row.op == Op::f32 || row.op == Op::nextafter) continue;
    std::size_t next = 3;
    std::string const lines = test::lines_on_numbers(row, 0, next);
    Graph const graph = function(lines, "%" + std::to_string(next - 1));
    std::vector<std::string> const one(request.begin(), request.begin() + 2), more(request.begin() + 2, request.end());
    for (auto const &texts : {one, more}) {
      Differences const requests(graph, wishes(texts));
      if (!requests.obstacle().empty()) continue;
      Graph const both = with(graph, texts);
      std::vector<double> const seeds(requests.seed_count(), 0.75);
      for (auto const &x : test::samples(row, 20)) {
        std::vector<double> at(x.begin(), x.end());
        std::vector<double> const inputs = at;
        at.insert(at.end(), seeds.begin(), seeds.end());
        std::vector<double> const found = outputs(both, at);
        auto const duals = DualNumbers(graph, requests.requests()).at(requests.seeds_of_requests(seeds), inputs, {});
        ASSERT_EQ(duals.size() + 1, found.size());
        for (std::size_t k = 0; k < duals.size(); ++k)
          if (auto const value = static_cast<double>(duals[k]); std::isfinite(value) && std::isfinite(found[1 + k]))
            EXPECT_NEAR(found[1 + k], value, 1e-9 * (1 + std::abs(value))) << row.name << " element " << k;
      }
    }
  }
}

// y[i] of x[i] and x[i + 1], then y[count - 1], the sum of all y[i], and x[0] times each x[i]: an arrow.
Graph chain(std::size_t count) {
  std::string const size = "[" + std::to_string(count) + "]\n";
  std::string text = "symreal-graph 1\nkernel \"k\"\ninput \"x\" " + size + "output \"y\" " + size, results;
  std::size_t next = 0;
  auto const add = [&](std::string const &line) {
    text += "%" + std::to_string(next) + " = " + line + "\n";
    return "%" + std::to_string(next++);
  };
  std::vector<std::string> x;
  for (std::size_t k = 0; k < count; ++k) x.push_back(add("input " + std::to_string(k)));
  std::string sum = "0";
  for (std::size_t k = 0; k + 1 < count; ++k) {
    std::string const product = add("mul " + x[k] + " " + x[k + 1]), sine = add("sin " + product);
    std::string const own = add("sub " + sine + " " + add("mul " + x[k] + " " + x[k]));
    results += "result " + std::to_string(k) + " " + own + "\n";
    sum = add("add " + sum + " " + add("mul 0.5 " + own));
    sum = add("sub " + sum + " " + add("mul " + x[0] + " " + x[k + 1]));
  }
  return read_graph(text + results + "result " + std::to_string(count - 1) + " " + sum + "\n", "test");
}

TEST(Differentiate, StructureIsThatOfTheGraph) {
  Graph const graph = chain(70); // more than one word of bits
  Pattern const rows = inputs_of(graph, graph.results);
  EXPECT_EQ(rows[64], (std::vector<std::uint32_t>{64, 65}));
  EXPECT_EQ(rows[69].size(), 70u);
  Pattern const coupled = coupled_inputs(graph, std::span(graph.results).first(69));
  EXPECT_EQ(coupled[64], (std::vector<std::uint32_t>{63, 64, 65}));
  EXPECT_EQ(coupled_inputs(graph, std::span(graph.results).last(1))[64], (std::vector<std::uint32_t>{0, 63, 64, 65}));
  Colouring const colours = coloured(Pattern(rows.begin(), rows.end() - 1), 70);
  EXPECT_EQ(colours.count, 2u);
  for (std::size_t k = 0; k + 1 < 70; ++k) EXPECT_NE(colours.colour[k], colours.colour[k + 1]);
}

// As many directions for many inputs as for few, and each element is what the formulas give.
TEST(Differentiate, InputsMoveAtOnce) {
  std::vector<std::string> const request = {"jacobian(y, x)", "hessian(y, x, weighted)", "vjp(y, x)", "jvp(y, x)"};
  std::vector<std::size_t> evaluations, passes;
  for (std::size_t const count : {20u, 80u}) {
    Graph const graph = chain(count);
    Differences const differences(graph, wishes(request));
    DualNumbers const duals(graph, differences.requests());
    evaluations.push_back(differences.evaluations()), passes.push_back(duals.passes());
    std::vector<double> x, seeds;
    for (std::size_t k = 0; k < count; ++k) x.push_back(std::sin(3.0 * static_cast<double>(k)) + 0.3);
    for (std::size_t k = 0; k < differences.seed_count(); ++k) seeds.push_back(std::cos(static_cast<double>(k)));
    std::vector<double> at = x;
    at.insert(at.end(), seeds.begin(), seeds.end());
    std::vector<double> const found = outputs(with(graph, request), at);
    std::vector<SharpNumber> const sharp = differences.at(at, {}, 1e-9);
    std::vector<long double> const exact = duals.at(differences.seeds_of_requests(seeds), x, {});
    ASSERT_EQ(sharp.size() + count, found.size());
    ASSERT_EQ(exact.size(), sharp.size());
    for (std::size_t k = 0; k < exact.size(); ++k) {
      EXPECT_NEAR(found[count + k], static_cast<double>(exact[k]), 1e-12) << "element " << k;
      if (!sharp[k]) continue;
      EXPECT_NEAR(found[count + k], static_cast<double>(*sharp[k]), 1e-7) << "element " << k;
    }
    EXPECT_GT(100 * std::ranges::count_if(sharp, &SharpNumber::has_value), 99 * std::ssize(sharp));
  }
  EXPECT_EQ(evaluations[0], evaluations[1]);
  EXPECT_EQ(passes[0], passes[1]);
}

// At kinks, zeros and poles the table says what is taken, and it is a number in the Hessian, too.
TEST(Differentiate, CornersAreNumbers) {
  struct Corner {
    char const *lines;
    std::vector<double> at, gradient;
  };
  Corner const corners[] = {
      {"%3 = pow %0 2\n", {0, 0, 0}, {0, 0, 0}},
      {"%3 = pow %0 1\n", {0, 0, 0}, {1, 0, 0}},
      {"%3 = pow %0 0\n", {0, 0, 0}, {0, 0, 0}},
      {"%3 = pow %0 3\n", {-2, 0, 0}, {12, 0, 0}},
      {"%3 = pow %0 0.5\n", {0, 0, 0}, {0, 0, 0}},
      {"%3 = pow %0 %1\n", {0, 2, 0}, {0, 0, 0}},
      {"%3 = pow %0 %1\n", {-2, 2, 0}, {-4, 0, 0}},
      {"%3 = sqrt %0\n", {0, 0, 0}, {0, 0, 0}},
      {"%3 = sqrt %0\n%4 = mul %3 %0\n", {0, 0, 0}, {0, 0, 0}},
      {"%3 = cbrt %0\n", {0, 0, 0}, {0, 0, 0}},
      {"%3 = hypot %0 %1\n", {0, 0, 0}, {0, 0, 0}},
      {"%3 = hypot %0 %1\n", {0, -2, 0}, {0, -1, 0}},
      {"%3 = atan2 %0 %1\n", {0, 0, 0}, {0, 0, 0}},
      {"%3 = atan2 %0 %1\n", {0, 2, 0}, {0.5, 0, 0}},
      {"%3 = acos %0\n", {1, 0, 0}, {0, 0, 0}},
      {"%3 = asin %0\n", {-1, 0, 0}, {0, 0, 0}},
      {"%3 = acosh %0\n", {1, 0, 0}, {0, 0, 0}},
      {"%3 = abs %0\n", {0, 0, 0}, {1, 0, 0}},
      {"%3 = abs %0\n", {-3, 0, 0}, {-1, 0, 0}},
      {"%3 = fmin %0 %1\n", {1, 1, 0}, {1, 0, 0}},
      {"%3 = fmax %0 %1\n", {1, 1, 0}, {1, 0, 0}},
      {"%3 = fmax %0 %1\n", {1, 2, 0}, {0, 1, 0}},
      {"%3 = floor %0\n", {1.5, 0, 0}, {0, 0, 0}},
      // The arm that is not taken has a pole: x != 0 ? sin(x) / x : 1.
      {"%3 = sin %0\n%4 = div %3 %0\n%5 = eq %0 0\n%6 = select %5 1 %4\n", {0, 0, 0}, {0, 0, 0}},
      {"%3 = lt 0 %0\n%4 = log %0\n%5 = mul %4 %1\n%6 = select %3 %5 %2\n", {0, 1, 1}, {0, 0, 1}},
  };
  for (Corner const &corner : corners) {
    auto const count = std::ranges::count(std::string_view(corner.lines), '\n'); // of nodes, the last is the result
    std::string const result = "%" + std::to_string(2 + count);
    Graph const graph = with(function(corner.lines, result), {"gradient(y)", "hessian(y, x)"});
    std::vector<double> const found = outputs(graph, corner.at);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(found[1 + k], corner.gradient[k]) << corner.lines << " by x" << k;
    for (double const number : found) EXPECT_TRUE(std::isfinite(number)) << corner.lines;
  }
}

TEST(Differentiate, ForwardAndReverseAgree) {
  Graph const graph = read_graph(
      "symreal-graph 1\nkernel \"k\"\ninput \"x\" [2]\noutput \"y\" [2]\n%0 = input 0\n%1 = input 1\n%2 = sin %0\n"
      "%3 = mul %2 %1\n%4 = exp %3\n%5 = div %4 %0\nresult 0 %5\nresult 1 %3\n",
      "test");
  Graph const all = with(graph, {"jacobian(y, x)", "jvp(y, x)", "vjp(y, x)"});
  double const direction[] = {2, -3}, weights[] = {0.5, 7};
  std::vector<double> const found = outputs(all, {1.25, 0.75, 2, -3, 0.5, 7});
  ASSERT_EQ(found.size(), 2u + 4 + 2 + 2);
  double const *const jacobian = &found[2];
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(found[6 + i], jacobian[2 * i] * direction[0] + jacobian[2 * i + 1] * direction[1], 1e-12);
    EXPECT_NEAR(found[8 + i], jacobian[i] * weights[0] + jacobian[2 + i] * weights[1], 1e-12);
  }
}

TEST(Differentiate, MatricesThatNoCompilerTakesAreRefused) {
  std::string text = "symreal-graph 1\nkernel \"k\"\ninput \"x\" [1100]\noutput \"y\" [1100]\n";
  for (int k = 0; k < 1100; ++k) text += "%" + std::to_string(k) + " = input " + std::to_string(k) + "\n";
  for (int k = 0; k < 1100; ++k) text += "result " + std::to_string(k) + " %" + std::to_string(k) + "\n";
  Graph const graph = read_graph(text, "test");
  try {
    (void)with(graph, {"jacobian(y, x)"});
    ADD_FAILURE();
  } catch (DiagnosticError const &error) {
    EXPECT_EQ(error.diagnostic().id, DiagnosticId::matrix_too_large);
  }
  EXPECT_EQ(with(graph, {"jacobian(y, x, sparse)"}).output_count(), 2200u);
}

// A chain of products of sines: by the linear cost of the reverse way, a gradient costs a few times the function.
TEST(Differentiate, GradientsCostAFewTimesTheFunction) {
  std::string text = "symreal-graph 1\nkernel \"k\"\ninput \"x\" [200]\noutput \"y\"\n";
  for (std::size_t k = 0; k < 200; ++k) text += "%" + std::to_string(k) + " = input " + std::to_string(k) + "\n";
  std::size_t last = 0, next = 200;
  for (std::size_t k = 1; k < 200; ++k) {
    text += "%" + std::to_string(next) + " = mul %" + std::to_string(last) + " %" + std::to_string(k) + "\n";
    text += "%" + std::to_string(next + 1) + " = add %" + std::to_string(next) + " %" + std::to_string(k - 1) + "\n";
    last = next + 1, next += 2;
  }
  Graph const graph = read_graph(text + "result 0 %" + std::to_string(last) + "\n", "test");
  std::size_t const before = live_operations(graph).arithmetic();
  EXPECT_LE(live_operations(with(graph, {"gradient(y)"})).arithmetic(), 4 * before);
}

} // namespace
} // namespace symreal
