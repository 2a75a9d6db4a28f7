#include "algebra/constant_forms.h"

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
TEST(ConstantForms, NothingIsFoundByChance) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0.01, 3);
  std::vector<double> constants(300);
  for (double &constant : constants) constant = uniform(random);
  ConstantForms const forms(constants);
  for (double constant : constants) EXPECT_EQ(forms.find(constant), nullptr) << constant;
}

} // namespace
} // namespace symreal::algebra
