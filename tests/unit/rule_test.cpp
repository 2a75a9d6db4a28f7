#include "passes/rule.h"

#include "graph/graph_text.h"
#include "operation_samples.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

namespace symreal {
namespace {

bool same_bits(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// Whether every operand and result is finite, as `finite` mode presumes.
bool all_finite(Term const &term, std::function<double(char)> const &variable) {
  for (Term const &operand : term.operands)
    if (!all_finite(operand, variable)) return false;
  return std::isfinite(evaluate(term, variable));
}

bool is_logical(Rule const &rule) { return info(rule.pattern.op).has(flag::LOGICAL); }

double draw(std::mt19937_64 &random, bool truth_value) {
  static constexpr double corners[] = {0.0, -0.0, 1.0, -1.0, 2.0, -0.5, 1e-300, -1e300, INFINITY, -INFINITY, NAN};
  if (truth_value) return static_cast<double>(random() % 2);
  if (random() % 3 == 0) return corners[random() % std::size(corners)];
  return test::sample(Domain::any, random);
}

TEST(Rules, HoldInTheirMode) {
  std::mt19937_64 random(7);
  for (Rule const &rule : rules()) {
    if (rule.mode == FloatingPoint::fast) continue;
    int compared = 0;
    for (int k = 0; k < 4000; ++k) {
      std::array<double, 26> values{};
      for (double &value : values) value = draw(random, is_logical(rule));
      if (rule.condition == Condition::k_has_exact_inverse)
        values['k' - 'a'] = std::ldexp(random() % 2 ? 1.0 : -1.0, static_cast<int>(random() % 200) - 100);
      if (rule.condition == Condition::k_zero) values['k' - 'a'] = random() % 2 ? 0.0 : -0.0;
      if (!holds_for_value(rule.condition, values['k' - 'a'])) continue;
      auto variable = [&](char name) { return values[static_cast<std::size_t>(name - 'a')]; };
      double before = evaluate(rule.pattern, variable), after = evaluate(rule.replacement, variable);
      bool strict = rule.mode == FloatingPoint::strict;
      if (!strict && !all_finite(rule.pattern, variable)) continue;
      EXPECT_TRUE(strict ? same_bits(before, after) : before == after)
          << rule.pattern_text << " " << before << " " << after;
      ++compared;
    }
    EXPECT_GT(compared, 500) << rule.pattern_text;
  }
}

// "x=1e-17 y=1"
std::array<double, 26> parse_counterexample(std::string_view text) {
  std::array<double, 26> values{};
  std::istringstream in{std::string(text)};
  for (std::string word; in >> word;) values[static_cast<std::size_t>(word[0] - 'a')] = std::stod(word.substr(2));
  return values;
}

TEST(Rules, FastOnesHaveACounterexampleForEarlierModes) {
  for (Rule const &rule : rules()) {
    EXPECT_EQ(rule.counterexample.empty(), rule.mode != FloatingPoint::fast) << rule.pattern_text;
    if (rule.counterexample.empty()) continue;
    std::array<double, 26> const values = parse_counterexample(rule.counterexample);
    auto variable = [&](char name) { return values[static_cast<std::size_t>(name - 'a')]; };
    EXPECT_NE(evaluate(rule.pattern, variable), evaluate(rule.replacement, variable)) << rule.pattern_text;
  }
}

} // namespace
} // namespace symreal
