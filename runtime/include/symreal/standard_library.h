// Specialisations of standard templates for RealNumber. The default numeric_limits would return 0 and silently ruin
// every tolerance built on it.
#pragma once

#include <symreal/complex.h>
#include <symreal/extremes.h>
#include <symreal/real_math.h>
#include <symreal/text.h>

#include <cstddef>
#include <limits>
#include <ostream>
#include <string>

namespace symreal::types {
// Prints the carried value.
std::ostream &operator<<(std::ostream &out, RealNumber x);
std::ostream &operator<<(std::ostream &out, SymbolicBool x);
std::istream &operator>>(std::istream &in, RealNumber &x);
} // namespace symreal::types

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
  size_t operator()(symreal::RealNumber x) const noexcept { return hash<double>()(static_cast<double>(x)); }
};

inline string to_string(symreal::RealNumber x) {
  if (!x.is_node()) return to_string(x.plain());
  string text = to_string(symreal::detail::needed_value(x));
  symreal::detail::made_string(text, x);
  return text;
}

} // namespace std
