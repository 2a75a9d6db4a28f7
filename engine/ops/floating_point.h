// The three floating-point modes, defined in docs/reference/floating-point.md.
#pragma once

#include <optional>
#include <string_view>

namespace symreal {

// Ordered: a rule that is valid in one mode is valid in every later one.
enum class FloatingPoint {
  strict, // bit-identical to the reference for all inputs, any NaN equal to any NaN
  finite, // equal (==) to the reference where all values are finite and no zero reaches an operation that sees its sign
  fast    // real-number algebra
};

inline std::string_view to_string(FloatingPoint mode) {
  switch (mode) {
  case FloatingPoint::strict: return "strict";
  case FloatingPoint::finite: return "finite";
  case FloatingPoint::fast: return "fast";
  }
  return "";
}

inline std::optional<FloatingPoint> parse_floating_point(std::string_view text) {
  for (FloatingPoint mode : {FloatingPoint::strict, FloatingPoint::finite, FloatingPoint::fast})
    if (to_string(mode) == text) return mode;
  return std::nullopt;
}

} // namespace symreal
