#include "engine/optimise/algebra/graph_network.h"

#include <gtest/gtest.h>
#include <random>

namespace symreal::algebra {
namespace {

constexpr double mass = 1.3778997716554911, offset = 0.35793823623424492, other = 0.076319326854959943;

TEST(ConstantForms, WhatWasRoundedIsSeen) {
  double const product = mass * offset, sum = mass + other, quotient = mass / offset, both = other - mass * offset;
  std::vector<double> const constants = {mass, offset, other, product, sum, quotient, -both};
  ConstantForms const forms(constants);
  ASSERT_NE(forms.find(product), nullptr);
  EXPECT_EQ(forms.find(product)->kind, FormKind::product);
  ASSERT_NE(forms.find(sum), nullptr);
  EXPECT_EQ(forms.find(sum)->kind, FormKind::sum);
  ASSERT_NE(forms.find(quotient), nullptr);
  EXPECT_EQ(forms.find(quotient)->kind, FormKind::quotient);
  ASSERT_NE(forms.find(-both), nullptr);
  for (double base : {mass, offset, other}) EXPECT_EQ(forms.find(base), nullptr) << base;
}

TEST(ConstantForms, TheNextNumberIsNone) {
  std::vector<double> const constants = {mass, offset, std::nextafter(mass * offset, 2)};
  ConstantForms const forms(constants);
  EXPECT_EQ(forms.find(constants[2]), nullptr);
}

TEST(ConstantForms, ShortNumbersAreWhatTheyAre) {
  std::vector<double> const constants = {2, 3, 6, 5, 0.5, 1.5, 10, 100};
  ConstantForms const forms(constants);
  for (double constant : constants) EXPECT_EQ(forms.find(constant), nullptr) << constant;
}

// Numbers that have nothing to do with one another.
std::vector<double> unrelated(std::size_t count) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0.01, 3);
  std::vector<double> constants(count);
  for (double &constant : constants) constant = uniform(random);
  return constants;
}

// A chain that repeats the numbers of its links ends with one whose numbers came first.
TEST(ConstantForms, WhatOccurredLongBeforeIsSeen) {
  std::vector<double> constants = unrelated(900);
  double const product = constants[1] * constants[700], both = constants[2] + constants[3] * constants[701];
  constants.insert(constants.end(), {product, both});
  ConstantForms const forms(constants);
  ASSERT_NE(forms.find(product), nullptr);
  EXPECT_EQ(forms.find(product)->kind, FormKind::product);
  ASSERT_NE(forms.find(both), nullptr);
  EXPECT_EQ(forms.find(both)->kind, FormKind::sum_with_product);
}

TEST(ConstantForms, NothingIsFoundByChance) {
  std::vector<double> const constants = unrelated(900);
  ConstantForms const forms(constants);
  for (double constant : constants) EXPECT_EQ(forms.find(constant), nullptr) << constant;
}

} // namespace
} // namespace symreal::algebra
