// Endings of guard texts. A guard text begins with the condition, which the driver replaces by the source's wording.
#pragma once

#include <algorithm>
#include <string_view>

namespace symreal {

inline constexpr std::string_view guard_is_false = " is false"; // the program took the other branch
inline constexpr std::string_view guard_gives = " gives ";      // of a conversion, followed by its integer
inline constexpr std::string_view guard_where = " where "; // followed by the selects' conditions under which it applies
inline constexpr std::string_view guard_of_several = "one of several paths comes by"; // of a disjunction of many paths

// Offset of the end of the condition.
inline std::size_t end_of_condition(std::string_view guard) {
  return std::min({guard.find(guard_is_false), guard.find(guard_gives), guard.find(guard_where), guard.size()});
}

} // namespace symreal
