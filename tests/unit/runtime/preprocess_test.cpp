// What crosses from preprocess to compute: the cheapest of all choices, and the same numbers.
#include "engine/graph/node_table.h"
#include "engine/graph/validate.h"
#include "engine/optimise/passes/min_cut.h"
#include "engine/optimise/passes/pass.h"

#include <gtest/gtest.h>
#include <random>

namespace symreal {
namespace {

TEST(Closure, IsTheBestOfAllChoices) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    Closure closure;
    std::size_t const count = 1 + random() % 10;
    std::vector<double> profits;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> needs;
    for (std::size_t i = 0; i < count; ++i) {
      profits.push_back(static_cast<double>(random() % 9) - 4);
      closure.add(profits.back());
    }
    for (std::size_t i = random() % 15; i > 0; --i) {
      needs.emplace_back(random() % count, random() % count);
      closure.require(needs.back().first, needs.back().second);
    }
    auto profit_of = [&](auto const &is_chosen) {
      double sum = 0;
      for (auto const &[item, needed] : needs)
        if (is_chosen(item) && !is_chosen(needed)) return -1e9;
      for (std::size_t i = 0; i < count; ++i) sum += is_chosen(i) ? profits[i] : 0;
      return sum;
    };
    double most = 0;
    std::size_t fewest = 0;
    for (std::uint32_t choice = 0; choice < 1u << count; ++choice) {
      double const profit = profit_of([&](std::size_t i) { return (choice >> i & 1) != 0; });
      auto const size = static_cast<std::size_t>(std::popcount(choice));
      if (profit > most || (profit == most && size < fewest)) most = profit, fewest = size;
    }
    std::vector<char> const best = closure.best();
    EXPECT_EQ(profit_of([&](std::size_t i) { return best[i] != 0; }), most);
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(best, 1)), fewest);
  }
}

// Operations on parameters, of which a variable part reads some.
Graph random_parametric(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  NodeTable table;
  Graph graph;
  graph.kernel = "k";
  graph.inputs = {{.label = "x", .extents = {}}};
  graph.parameters = {{.label = "p", .extents = {3}, .first = 0, .count = 3}};
  graph.input_values = {0.5};
  graph.parameter_values.assign(3, 0.5);
  std::vector<NodeId> nodes;
  for (std::uint32_t slot = 0; slot < 3; ++slot) nodes.push_back(table.intern(Node::parameter(slot)));
  auto any = [&] { return nodes[random() % nodes.size()]; };
  for (int k = 0; k < 8; ++k) {
    constexpr Op ops[] = {Op::neg, Op::add, Op::sub, Op::mul, Op::div, Op::sin, Op::abs};
    Op const op = ops[random() % std::size(ops)];
    NodeId const a = any(), b = arity(op) == 2 ? any() : no_node;
    nodes.push_back(table.intern(table.operation(op, a, b)));
  }
  NodeId const x = table.intern(Node::input(0));
  for (int k = 0; k < 4; ++k) graph.results.push_back(table.intern(table.operation(Op::mul, x, any())));
  graph.results.push_back(any());
  graph.outputs = {{.label = "y", .extents = {5}, .first = 0, .count = 5}};
  graph.nodes = table.release();
  return graph;
}

// Of loads and of what compute does on them.
double cost(Graph const &graph, CostModel const &costs) {
  std::vector<char> const recomputed = recomputed_nodes(graph);
  double sum = costs.load * static_cast<double>(graph.precomputed.size());
  for (NodeId id = 0; id < graph.nodes.size(); ++id)
    if (recomputed[id]) sum += costs[graph.nodes[id].op];
  return sum;
}

// All sets of values that preprocess could store.
double least_cost(Graph graph, CostModel const &costs) {
  std::vector<NodeId> parametric;
  for (NodeId id = 0; id < graph.nodes.size(); ++id)
    if (graph.nodes[id].attribute == Attribute::parametric) parametric.push_back(id);
  double least = 1e9;
  for (std::uint32_t choice = 1; choice < 1u << parametric.size(); ++choice) {
    graph.precomputed.clear();
    for (std::size_t i = 0; i < parametric.size(); ++i)
      if (choice >> i & 1) graph.precomputed.push_back(parametric[i]);
    // Parameters that are read where they are not stored would be.
    std::vector<char> needed(graph.nodes.size(), 0), stored(graph.nodes.size(), 0);
    for (NodeId id : graph.precomputed) stored[id] = 1;
    for (NodeId id : graph.results) needed[id] = 1;
    bool is_whole = true;
    for (auto id = static_cast<NodeId>(graph.nodes.size()); id-- > 0;) {
      Node const &node = graph.nodes[id];
      if (!needed[id] || stored[id]) continue;
      is_whole = is_whole && node.op != Op::parameter;
      if (is_leaf(node.op)) continue;
      for (NodeId operand : node.operand)
        if (operand != no_node) needed[operand] = 1;
    }
    if (is_whole) least = std::min(least, cost(graph, costs));
  }
  return least;
}

TEST(Preprocess, StoresTheCheapestChoice) {
  std::vector<std::string> const pass = {"preprocess"};
  std::size_t recomputed = 0;
  for (double load : {1.0, 2.0, 3.5})
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
      CostModel costs = usual_costs();
      costs.load = load;
      Graph const graph = random_parametric(seed), made = run_passes(graph, pass, {FloatingPoint::strict, 0, costs});
      ASSERT_EQ(find_violation(made), "");
      EXPECT_DOUBLE_EQ(cost(made, costs), least_cost(graph, costs)) << seed;
      recomputed += static_cast<std::size_t>(std::ranges::count(recomputed_nodes(made), 1));
      if (load == 1) {
        std::vector<char> const again = recomputed_nodes(made);
        for (NodeId id = 0; id < made.nodes.size(); ++id)
          if (again[id]) EXPECT_EQ(info(made.nodes[id].op).cost, 0) << "no operation that counts";
      }
    }
  EXPECT_GT(recomputed, 30u);
}

} // namespace
} // namespace symreal
