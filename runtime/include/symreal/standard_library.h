// Specialisations of standard templates for RealNumber. The default numeric_limits would return 0 and silently ruin
// every tolerance built on it.
#pragma once

#include <symreal/extremes.h>
#include <symreal/library_formulas.h>
#include <symreal/real_math.h>
#include <symreal/standard_templates.h>
#include <symreal/text.h>

#include <cstddef>
#include <limits>

namespace symreal::types {
// Prints the carried value.
std::ostream &operator<<(std::ostream &out, RealNumber x);
std::ostream &operator<<(std::ostream &out, SymbolicBool x);
std::istream &operator>>(std::istream &in, RealNumber &x);
} // namespace symreal::types

namespace symreal::detail {
std::size_t hash(double number) noexcept;
// Prints as std::to_string does, and returns the length.
constexpr std::size_t longest_number = 400;
std::size_t print_number(RealNumber x, char (&text)[longest_number]) noexcept;
} // namespace symreal::detail

namespace std {

template <> class numeric_limits<symreal::RealNumber> : public numeric_limits<double> {
  using Double = numeric_limits<double>;
  using Real = symreal::RealNumber;

public:
  static constexpr Real min() noexcept { return Double::min(); }
  static constexpr Real max() noexcept { return Double::max(); }
  static constexpr Real lowest() noexcept { return Double::lowest(); }
  static constexpr Real epsilon() noexcept { return Double::epsilon(); }
  static constexpr Real round_error() noexcept { return Double::round_error(); }
  static constexpr Real infinity() noexcept { return Double::infinity(); }
  static constexpr Real quiet_NaN() noexcept { return Double::quiet_NaN(); }
  static constexpr Real signaling_NaN() noexcept { return Double::signaling_NaN(); }
  static constexpr Real denorm_min() noexcept { return Double::denorm_min(); }
};

template <> struct hash<symreal::RealNumber> {
  // Equal numbers have equal hashes, and the lookup is a decision like any comparison.
  size_t operator()(symreal::RealNumber x) const noexcept { return symreal::detail::hash(static_cast<double>(x)); }
};

// A template, since the class may be defined later.
template <class String = string> String to_string(symreal::RealNumber x) {
  char text[symreal::detail::longest_number];
  return String(text, symreal::detail::print_number(x, text));
}

} // namespace std
