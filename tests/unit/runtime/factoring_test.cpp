// Each way of finding structure by itself: what it finds in small networks.
#include "engine/optimise/algebra/search.h"

#include <gtest/gtest.h>

namespace symreal::algebra {
namespace {

class Factoring : public ::testing::Test {
protected:
  Network network{std::make_shared<Context>()};
  SearchState search{1};

  Literal input(std::uint32_t slot) { return network.leaf(slot, Attribute::variable, no_hazard, random_value(slot)); }
  Literal parameter(std::uint32_t slot) {
    return network.leaf(100 + slot, Attribute::parametric, no_hazard, random_parameter(slot));
  }
  Network factor(ExpansionSettings const &settings = {}) {
    return rebuilt(factored(network, {.expansion = settings}, search));
  }
  void expect_same_roots(Network const &made) const {
    for (std::size_t i = 0; i < network.roots.size(); ++i)
      EXPECT_TRUE(equal_in_field(made.value(made.roots[i]), network.value(network.roots[i])));
  }
};

TEST_F(Factoring, CommonFactorsAreTakenOut) {
  Literal const c = input(0), r = input(1), w = input(2), v = input(3);
  // c r w + c v is c (v + r w)
  network.roots = {network.sum(network.product(network.product(c, r), w), network.product(c, v))};
  EXPECT_EQ(cost_of(network), 4u);
  Network const made = factor();
  EXPECT_EQ(cost_of(made), 3u);
  expect_same_roots(made);
}

TEST_F(Factoring, SumsThatSeveralHaveAreComputedOnce) {
  Literal const a = input(0), b = input(1), x = input(2), y = input(3);
  for (Literal factor : {x, y})
    network.roots.push_back(network.sum(network.product(a, factor), -network.product(b, factor)));
  EXPECT_EQ(cost_of(network), 6u);
  Network const made = factor();
  EXPECT_EQ(cost_of(made), 3u) << "(a - b) x, (a - b) y";
  expect_same_roots(made);
}

TEST_F(Factoring, WhatCancelsGoesAway) {
  Literal const a = input(0), b = input(1), c = input(2);
  Literal const sum = network.sum(a, b), difference = network.sum(a, c);
  // a (a + b) - b (a + c) + b c: two products multiplied out leave a^2
  network.roots = {network.sum(network.product(a, sum), -network.product(b, difference))};
  EXPECT_LE(cost_of(factor({.sum_size = 8, .most_uses = 8})), 3u);
}

TEST_F(Factoring, ParametersCostNothing) {
  Literal const x = input(0), p = parameter(0), q = parameter(1);
  network.roots = {network.sum(network.product(network.product(x, p), q), network.product(x, q))};
  EXPECT_EQ(cost_of(factor()), 1u) << "x (p q + q)";
}

TEST_F(Factoring, MultipliesOutNoFurtherThanAllowed) {
  Literal product = network.one();
  for (std::uint32_t i = 0; i < 8; ++i) product = network.product(product, network.sum(input(2 * i), input(2 * i + 1)));
  network.roots = {product};
  Expansion const expansion = expand(network, {.most_terms = 16});
  for (Expression const &expression : expansion.expressions) EXPECT_LE(expression.terms.size(), 16u);
  expect_same_roots(factor());
}

TEST_F(Factoring, ResubstitutionUsesWhatIsThere) {
  Literal const a = input(0), b = input(1), c = input(2), d = input(3);
  Literal const sum = network.sum(network.sum(a, b), c);
  // a b + a c + a d + b + c + d is a (b + c + d) + (b + c + d)
  Literal const rest = network.sum(network.sum(b, c), d);
  Literal const other = network.sum(network.sum(network.product(a, b), network.product(a, c)), network.product(a, d));
  network.roots = {sum, rest, other};
  Network const made = rebuilt(resubstituted(network, false, search));
  EXPECT_LT(cost_of(made), cost_of(network));
  expect_same_roots(made);
}

// x in place of (y / z) z is one thing, (y / z) z in place of y another.
TEST_F(Factoring, ResubstitutionComesToRestOnNoDivision) {
  Literal const x = input(0), y = input(1), z = input(2);
  Literal const quotient = network.quotient(y, z);
  // x y + y is (x + 1) y; with q = y / z there, y is q z.
  network.roots = {quotient, network.sum(network.product(x, y), network.product(y, y)), network.product(quotient, x)};
  Network const made = rebuilt(resubstituted(network, false, search));
  EXPECT_EQ(made[made.roots[1]].hazards, no_hazard);
  expect_same_roots(made);
}

TEST_F(Factoring, WindowsKeepWhatCrossesThem) {
  std::vector<Literal> values;
  for (std::uint32_t i = 0; i < 8; ++i) values.push_back(input(i));
  for (std::uint64_t i = 0; i < 400; ++i) {
    auto any = [&] { return values[mixed(i * 3 + values.size()) % values.size()]; };
    Literal const a = any(), b = values[mixed(i) % values.size()], c = values[mixed(i + 77) % values.size()];
    values.push_back(network.sum(network.product(a, b), network.product(a, c)));
    if (network[values.back()].is_free()) values.pop_back();
  }
  network.roots.assign(values.end() - 6, values.end());
  for (std::size_t length : {20u, 100u}) {
    Network const made = improved_in_windows(network, {.length = length, .steps = 4}, search);
    EXPECT_LT(cost_of(made), cost_of(network));
    expect_same_roots(made);
  }
}

} // namespace
} // namespace symreal::algebra
