// Formatting of times.
#pragma once

#include <fmt/format.h>

#include <string>

namespace symreal::tool {

// Three digits in a suitable unit.
inline std::string time_text(double nanoseconds) {
  if (nanoseconds < 1e3) return fmt::format("{:.0f} ns", nanoseconds);
  if (nanoseconds < 1e6) return fmt::format("{:.3g} us", nanoseconds / 1e3);
  return fmt::format("{:.3g} ms", nanoseconds / 1e6);
}

} // namespace symreal::tool
