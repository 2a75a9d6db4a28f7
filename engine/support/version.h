#pragma once

#include <string_view>

namespace symreal {

inline constexpr std::string_view version = SYMREAL_VERSION;

} // namespace symreal
