// What the modes promise (docs/floating-point.md), on random graphs of all operations on numbers: after all passes,
// strict gives the same bits at any operands, finite gives equal numbers where the premises hold. 10000 graphs a mode,
// or as many as SYMREAL_RANDOM_GRAPHS says.
#include "graph/evaluate.h"
#include "graph/graph_text.h"
#include "graph/node_table.h"
#include "passes/pass.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <iostream>
#include <limits>
#include <optional>
#include <random>
#include <sstream>

namespace symreal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
constexpr double corners[] = {0,       -0.0,  1,      -1,       2,  0.5,      -3,        0.1, 1e-310,
                              -5e-324, 1e300, -1e300, 0x1p-600, 10, infinity, -infinity, nan};

bool is_on_numbers(OperationInfo const &row) {
  using namespace flag;
  return row.domain != Domain::integer && !row.has(OPAQUE | STRUCTURE | EFFECT | WIDE | TAKES_WIDE) &&
         !row.name.starts_with("int");
}

class RandomGraph {
public:
  explicit RandomGraph(std::uint64_t seed) : random_(seed) {
    for (std::uint32_t slot = 0; slot < 4; ++slot) numbers_.push_back(table_.intern(Node::input(slot)));
    for (std::uint32_t slot = 0; slot < 2; ++slot) numbers_.push_back(table_.intern(Node::parameter(slot)));
    truths_.push_back(table_.intern(table_.operation(Op::lt, numbers_[0], numbers_[1])));
    for (std::size_t count = 5 + random_() % 40; count > 0; --count) add();
  }

  Graph graph() {
    Graph graph;
    graph.kernel = "k";
    graph.inputs = {{.label = "x", .extents = {4}, .first = 0, .count = 4}};
    graph.parameters = {{.label = "p", .extents = {2}, .first = 0, .count = 2}};
    graph.input_values.assign(4, 0.5);
    graph.parameter_values.assign(2, 0.5);
    graph.outputs = {{.label = "y", .extents = {3}, .first = 0, .count = 3}};
    for (int k = 0; k < 3; ++k) graph.results.push_back(numbers_[numbers_.size() - 1 - random_() % 4]);
    if (random_() % 4 == 0) graph.guards.push_back({.condition = truths_.back(), .text = "holds"});
    graph.nodes = table_.release();
    return graph;
  }

private:
  // Few nodes to choose from: so operands are equal, and rules have something to find.
  NodeId any(std::vector<NodeId> const &nodes) {
    return nodes[nodes.size() - 1 - random_() % std::min<std::size_t>(nodes.size(), 8)];
  }
  NodeId number() {
    if (random_() % 6 == 0) return table_.constant(corners[random_() % std::size(corners)]);
    return random_() % 8 == 0 ? any(truths_) : any(numbers_);
  }

  void add() {
    static std::vector<OperationInfo> const rows = [] {
      std::vector<OperationInfo> all;
      for (OperationInfo const &row : operations())
        if (is_on_numbers(row)) all.push_back(row);
      return all;
    }();
    constexpr Op frequent[] = {Op::add, Op::sub, Op::mul, Op::div, Op::neg, Op::abs, Op::lt, Op::select};
    OperationInfo const &row =
        random_() % 2 == 0 ? info(frequent[random_() % std::size(frequent)]) : rows[random_() % rows.size()];
    NodeId operand[3] = {no_node, no_node, no_node};
    for (std::size_t k = 0; k < row.arity; ++k) {
      bool const is_truth = row.has(flag::LOGICAL) || (row.form == Form::select && k == 0);
      operand[k] = is_truth ? any(truths_) : number();
    }
    NodeId const made = table_.intern(table_.operation(row.op, operand[0], operand[1], operand[2]));
    (row.has(flag::BOOLEAN) ? truths_ : numbers_).push_back(made);
  }

  std::mt19937_64 random_;
  NodeTable table_;
  std::vector<NodeId> numbers_, truths_;
};

std::uint64_t wanted_graphs() {
  char const *const wanted = std::getenv("SYMREAL_RANDOM_GRAPHS");
  return wanted ? std::strtoull(wanted, nullptr, 10) : 10000;
}

std::string text(Graph const &graph) {
  std::ostringstream out;
  write_graph(out, graph);
  return out.str();
}

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

// Nothing where the guard can never hold.
std::optional<Graph> passed(Graph const &graph, FloatingPoint mode) {
  try {
    return run_passes(graph, default_passes(), mode);
  } catch (DiagnosticError const &error) {
    EXPECT_EQ(error.diagnostic().id, DiagnosticId::contradictory_guard);
    return {};
  }
}

// Compares all outputs of a random graph before and after the passes; counts what it compared.
void expect_promise(FloatingPoint mode, std::uint64_t seed, std::size_t &compared) {
  Graph const graph = RandomGraph(seed).graph();
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
  std::uint64_t const graphs = wanted_graphs();
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
