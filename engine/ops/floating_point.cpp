#include "engine/ops/floating_point.h"

namespace symreal {

std::string_view to_string(FloatingPoint mode) {
  switch (mode) {
  case FloatingPoint::strict: return "strict";
  case FloatingPoint::finite: return "finite";
  case FloatingPoint::fast: return "fast";
  }
  return "";
}

std::optional<FloatingPoint> parse_floating_point(std::string_view text) {
  for (FloatingPoint mode : {FloatingPoint::strict, FloatingPoint::finite, FloatingPoint::fast})
    if (to_string(mode) == text) return mode;
  return std::nullopt;
}

} // namespace symreal
