#include "engine/ops/operation.h"

#include "engine/graph/evaluate.h"
#include "engine/graph/graph_text.h"
#include "engine/optimise/passes/term.h"
#include "operation_samples.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace symreal {
namespace {

// A graph of one operation on inputs.
Graph graph_of(OperationInfo const &operation) {
  std::string text = "symreal-graph 1\nkernel \"k\"\ninput \"x\" [3]\noutput \"y\"\n%0 = input 0\n%1 = input 1\n"
                     "%2 = input 2\n";
  std::size_t next = 3;
  text += test::lines_on_numbers(operation, 0, next);
  return read_graph(text + "result 0 %" + std::to_string(next - 1) + "\n", "test");
}

TEST(Operations, AreFoundByTheirNames) {
  std::set<std::string_view> names;
  for (OperationInfo const &operation : operations()) {
    EXPECT_TRUE(names.insert(operation.name).second) << operation.name;
    EXPECT_EQ(find_operation(operation.name), operation.op);
    EXPECT_EQ(&info(operation.op), &operation);
    EXPECT_TRUE(operation.arity >= 1 && operation.arity <= 3);
    EXPECT_FALSE(operation.doc.empty());
  }
  EXPECT_FALSE(find_operation("constant"));
}

TEST(Operations, TextFormReadsBack) {
  for (OperationInfo const &operation : operations()) {
    if (operation.has(flag::OPAQUE)) continue; // it needs what it refers to: tests/passes/opaque.graph
    Graph const graph = graph_of(operation);
    std::ostringstream first, second;
    write_graph(first, graph);
    write_graph(second, read_graph(first.str(), "again"));
    EXPECT_EQ(first.str(), second.str());
  }
}

TEST(Operations, GraphsEvaluateThem) {
  for (OperationInfo const &operation : operations()) {
    if (operation.has(flag::OPAQUE)) continue;
    Graph const graph = graph_of(operation);
    for (auto const &x : test::samples(operation, 20)) {
      double direct = test::on_numbers(operation, x);
      EXPECT_EQ(evaluate(graph, x, {}).back(), direct) << operation.name;
      EXPECT_TRUE(std::isfinite(direct)) << operation.name << " leaves its domain";
    }
  }
}

TEST(Operations, CommutativeOnesCommute) {
  for (OperationInfo const &operation : operations()) {
    if (!operation.has(flag::COMMUTATIVE)) continue;
    ASSERT_EQ(operation.arity, 2u);
    for (auto const &x : test::samples(operation, 50))
      EXPECT_EQ(std::bit_cast<std::uint64_t>(evaluate(operation.op, x[0], x[1], 0)),
                std::bit_cast<std::uint64_t>(evaluate(operation.op, x[1], x[0], 0)));
  }
}

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    std::size_t end = std::min(text.find(';'), text.size());
    parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

// Where an operation has corners or steps, a sample next to one says nothing about the derivative.
bool is_smooth_at(OperationInfo const &operation, std::array<double, 3> x, std::size_t i, double step) {
  Op const op = operation.op;
  if (operation.has(flag::BOOLEAN) || op == Op::f32 || (op == Op::select && i == 0)) return false;
  std::array<double, 3> low = x, high = x;
  low[i] -= 4 * step, high[i] += 4 * step;
  for (Op kind : {Op::floor, Op::round})
    for (std::size_t k = 0; k < 2; ++k)
      if (evaluate(kind, low[k], 0, 0) != evaluate(kind, high[k], 0, 0)) return false;
  if (op == Op::fmod || op == Op::remainder)
    if (std::round(2 * low[0] / low[1]) != std::round(2 * high[0] / high[1]) ||
        std::trunc(2 * low[0] / low[1]) != std::trunc(2 * high[0] / high[1]))
      return false;
  return (low[0] < low[1]) == (high[0] < high[1]) && (low[0] > 0) == (high[0] > 0);
}

TEST(Operations, DerivativesMatchDifferences) {
  for (OperationInfo const &operation : operations()) {
    std::vector<std::string_view> derivatives = split(operation.derivative);
    if (derivatives.empty()) continue;
    ASSERT_EQ(derivatives.size(), operation.arity) << operation.name;
    int compared = 0;
    for (auto const &x : test::samples(operation, 40)) {
      double result = evaluate(operation.op, x[0], x[1], x[2]);
      for (std::size_t i = 0; i < operation.arity; ++i) {
        double const step = 1e-6;
        if (!is_smooth_at(operation, x, i, step)) continue;
        std::array<double, 3> low = x, high = x;
        low[i] -= step, high[i] += step;
        double difference =
            (evaluate(operation.op, high[0], high[1], high[2]) - evaluate(operation.op, low[0], low[1], low[2])) /
            (2 * step);
        double symbolic = evaluate(parse_term(derivatives[i]), [&](char name) {
          return name == 'r' ? result : x[static_cast<std::size_t>(name - 'x')];
        });
        EXPECT_NEAR(symbolic, difference, 1e-6 * (1 + std::abs(symbolic))) << operation.name << " operand " << i;
        ++compared;
      }
    }
    bool compares = !operation.has(flag::BOOLEAN) && operation.op != Op::f32;
    EXPECT_TRUE(!compares || compared > 5) << operation.name;
  }
}

} // namespace
} // namespace symreal
