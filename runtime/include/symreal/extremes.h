// min, max and clamp of <algorithm> on RealNumber: selects, in every mode and under every policy. They pick as the
// templates do, (a < b) ? b : a; not as fmax, which treats NaN in another way.
#pragma once

#include <symreal/real_math.h>
#include <symreal/standard_templates.h>

#include <initializer_list>

namespace symreal {

[[gnu::always_inline]] inline RealNumber max(RealNumber a, RealNumber b) noexcept { return select(a < b, b, a); }
[[gnu::always_inline]] inline RealNumber min(RealNumber a, RealNumber b) noexcept { return select(b < a, b, a); }
[[gnu::always_inline]] inline RealNumber clamp(RealNumber x, RealNumber low, RealNumber high) noexcept {
  return select(x < low, low, select(high < x, high, x));
}
[[gnu::always_inline]] inline RealNumber max(std::initializer_list<RealNumber> list) noexcept {
  RealNumber result = *list.begin();
  for (RealNumber x : list) result = max(result, x);
  return result;
}
[[gnu::always_inline]] inline RealNumber min(std::initializer_list<RealNumber> list) noexcept {
  RealNumber result = *list.begin();
  for (RealNumber x : list) result = min(result, x);
  return result;
}

namespace detail {
// Permanent storage for a result that is returned by reference.
RealNumber const &keep(RealNumber x);
} // namespace detail

} // namespace symreal

namespace std {
using symreal::clamp;
using symreal::max;
using symreal::min;

// Chosen by std::max<double>(x, y), which returns a reference.
template <> inline symreal::RealNumber const &max(symreal::RealNumber const &a, symreal::RealNumber const &b) {
  if (!a.is_node() && !b.is_node()) return a.plain() < b.plain() ? b : a;
  return symreal::detail::keep(symreal::max(a, b));
}
template <> inline symreal::RealNumber const &min(symreal::RealNumber const &a, symreal::RealNumber const &b) {
  if (!a.is_node() && !b.is_node()) return b.plain() < a.plain() ? b : a;
  return symreal::detail::keep(symreal::min(a, b));
}
template <> inline symreal::RealNumber const &clamp(symreal::RealNumber const &x, symreal::RealNumber const &low,
                                                    symreal::RealNumber const &high) {
  return symreal::detail::keep(symreal::clamp(x, low, high));
}
} // namespace std
