// An effort is a bound on work that grows no faster than the graph, whatever its form.
#include "engine/optimise/algebra/graph_network.h"
#include "engine/optimise/algebra/search.h"

#include "graph_builder.h"

#include <functional>
#include <gtest/gtest.h>

namespace symreal::algebra {
namespace {

using test::GraphBuilder;
using Form = std::function<NodeId(GraphBuilder &, int)>;

// Each the square of the one before: its powers double.
NodeId squares(GraphBuilder &make, int operations) {
  NodeId x = make.input(0);
  for (int k = 0; k < operations; ++k) x = make(Op::mul, x, x);
  return x;
}

// Horner's rule in several variables: what is multiplied out has many terms of many factors.
NodeId sums(GraphBuilder &make, int operations) {
  NodeId x = make.input(0);
  for (int k = 0; k < operations / 2; ++k)
    x = make(Op::add, make(Op::mul, x, make.input(static_cast<std::uint32_t>(k) % 5)), make.number(k + 0.5));
  return x;
}

// Each depends on all before.
NodeId functions(GraphBuilder &make, int operations) {
  NodeId x = make.input(0);
  for (int k = 0; k < operations / 2; ++k)
    x = make(Op::add, make(Op::mul, make(Op::sin, x), make.input(static_cast<std::uint32_t>(k) % 5)), x);
  return x;
}

// A product of sums, as a tree.
NodeId products(GraphBuilder &make, int operations) {
  std::vector<NodeId> level;
  for (int k = 0; k < operations / 2; ++k)
    level.push_back(make(Op::add, make.input(static_cast<std::uint32_t>(k) % 5), make.number(k + 0.25)));
  for (; level.size() > 1; level.resize((level.size() + 1) / 2))
    for (std::size_t k = 0; k < level.size(); k += 2)
      level[k / 2] = k + 1 < level.size() ? make(Op::mul, level[k], level[k + 1]) : level[k];
  return level[0];
}

Form const forms[] = {squares, sums, functions, products};

Searched searched(Form const &form, int operations, int effort) {
  GraphBuilder make;
  NodeId const result = form(make, operations);
  return searched(network_of(make.finish({result}), usual_costs()), effort);
}

TEST(Search, WorkGrowsNoFasterThanTheGraph) {
  for (std::size_t k = 0; k < std::size(forms); ++k) {
    std::uint64_t const few = searched(forms[k], 150, 1).work, many = searched(forms[k], 600, 1).work;
    EXPECT_LE(many, 5 * few + 300'000) << "form " << k;
    EXPECT_LE(many, 300'000 + 600 * 10'000) << "form " << k;
  }
}

TEST(Search, EffortsBoundTheWorkOnSmallGraphs) {
  for (std::size_t k = 0; k < std::size(forms); ++k) {
    std::uint64_t const usual = searched(forms[k], 8, 2).work;
    EXPECT_LE(usual, 8 * 310'000 + 100'000) << "form " << k;
  }
  EXPECT_LE(searched(squares, 3, 3).work, 10 * 3 * 310'000 + 100'000);
}

TEST(Search, DoesNothingWhereNothingCanBeSaved) {
  GraphBuilder make;
  NodeId x = make.input(0);
  for (int k = 0; k < 1000; ++k) x = make(Op::sin, x);
  EXPECT_EQ(searched(network_of(make.finish({x}), usual_costs()), 3).work, 0U);
}

} // namespace
} // namespace symreal::algebra
