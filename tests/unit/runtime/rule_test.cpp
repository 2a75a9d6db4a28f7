// Every rule of the table is valid in its mode: both sides are computed on drawn operands. The two sides of a fast rule
// are equal but for rounding, and differ at the row's counterexample.
#include "engine/optimise/passes/rule.h"

#include "operation_samples.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>

namespace symreal {
namespace {

using Letters = std::array<double, 26>;

double &letter(Letters &values, char name) { return values[static_cast<std::size_t>(name - 'a')]; }

bool same_bits(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// The largest magnitude among all operands and results: what the error of rounding is in proportion to.
double largest(Term const &term, std::function<double(char)> const &variable) {
  double result = std::fabs(evaluate(term, variable));
  for (Term const &operand : term.operands) result = std::max(result, largest(operand, variable));
  return result;
}

// Whether every operand and result is finite, as modes finite and fast presume.
bool all_finite(Term const &term, std::function<double(char)> const &variable) {
  for (Term const &operand : term.operands)
    if (!all_finite(operand, variable)) return false;
  return std::isfinite(evaluate(term, variable));
}

bool equal_in(FloatingPoint mode, Rule const &rule, std::function<double(char)> const &variable) {
  double const before = evaluate(rule.pattern, variable), after = evaluate(rule.replacement, variable);
  switch (mode) {
  case FloatingPoint::strict: return same_bits(before, after);
  case FloatingPoint::finite: return before == after;
  case FloatingPoint::fast: break;
  }
  double const size = std::max(largest(rule.pattern, variable), largest(rule.replacement, variable));
  return std::fabs(before - after) <= 8 * std::numeric_limits<double>::epsilon() * size;
}

double draw(std::mt19937_64 &random, Rule const &rule) {
  static constexpr double corners[] = {0.0, -0.0, 1.0, -1.0, 2.0, -0.5, 1e-300, -1e300, INFINITY, -INFINITY, NAN};
  if (info(rule.pattern.op).has(flag::LOGICAL)) return static_cast<double>(random() % 2); // a truth value
  // Algebra is that of numbers whose squares neither overflow nor vanish.
  if (rule.mode != FloatingPoint::fast && random() % 3 == 0) return corners[random() % std::size(corners)];
  return test::sample(Domain::any, random);
}

Letters draw_letters(std::mt19937_64 &random, Rule const &rule) {
  Letters values{};
  for (double &value : values) value = draw(random, rule);
  if (rule.condition == Condition::k_has_exact_inverse)
    letter(values, 'k') = std::ldexp(random() % 2 ? 1.0 : -1.0, static_cast<int>(random() % 200) - 100);
  if (rule.condition == Condition::k_zero) letter(values, 'k') = random() % 2 ? 0.0 : -0.0;
  return values;
}

TEST(Rules, HoldInTheirMode) {
  std::mt19937_64 random(7);
  for (Rule const &rule : rules()) {
    int compared = 0;
    // Another libm may round in another way, whatever this one does.
    bool const is_finite = rule.mode == FloatingPoint::finite && info(rule.pattern.op).has(flag::ROUNDED);
    bool differs_earlier = false;
    for (int k = 0; k < 4000; ++k) {
      Letters values = draw_letters(random, rule);
      if (!holds_for_value(rule.condition, letter(values, 'k'))) continue;
      auto variable = [&](char name) { return letter(values, name); };
      if (is_finite) differs_earlier |= !equal_in(FloatingPoint::strict, rule, variable);
      if (rule.mode != FloatingPoint::strict && !all_finite(rule.pattern, variable)) continue;
      EXPECT_TRUE(equal_in(rule.mode, rule, variable)) << rule.pattern_text << " " << evaluate(rule.pattern, variable)
                                                       << " " << evaluate(rule.replacement, variable);
      ++compared;
    }
    EXPECT_GT(compared, 500) << rule.pattern_text;
    if (is_finite) EXPECT_TRUE(differs_earlier) << rule.pattern_text << " holds in strict";
  }
}

// "x=1e-17 y=1"
Letters parse_counterexample(std::string_view text) {
  Letters values{};
  std::istringstream in{std::string(text)};
  for (std::string word; in >> word;) letter(values, word[0]) = std::stod(word.substr(2));
  return values;
}

TEST(Rules, FastOnesHaveACounterexampleForEarlierModes) {
  for (Rule const &rule : rules()) {
    EXPECT_EQ(rule.counterexample.empty(), rule.mode != FloatingPoint::fast) << rule.pattern_text;
    if (rule.counterexample.empty()) continue;
    Letters values = parse_counterexample(rule.counterexample);
    auto variable = [&](char name) { return letter(values, name); };
    EXPECT_TRUE(holds_for_value(rule.condition, letter(values, 'k'))) << rule.pattern_text;
    EXPECT_TRUE(all_finite(rule.pattern, variable)) << rule.pattern_text << " is not within the premise of finite";
    EXPECT_FALSE(equal_in(FloatingPoint::finite, rule, variable)) << rule.pattern_text;
  }
}

} // namespace
} // namespace symreal
