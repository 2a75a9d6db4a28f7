// How the text of a guard ends. Before it stands the condition, which the driver knows in the words of the source.
#pragma once

#include <algorithm>
#include <string_view>

namespace symreal {

inline constexpr std::string_view guard_is_false = " is false"; // the program decided so
inline constexpr std::string_view guard_gives = " gives ";      // of a conversion, with the integer
inline constexpr std::string_view guard_where = " where ";      // under which conditions of selects it decided
inline constexpr std::string_view guard_of_several = "one of several paths comes by"; // under many conditions

// The offset at which the condition ends.
inline std::size_t end_of_condition(std::string_view guard) {
  return std::min({guard.find(guard_is_false), guard.find(guard_gives), guard.find(guard_where), guard.size()});
}

} // namespace symreal
