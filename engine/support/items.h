// Text in parts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// Without the blanks, tabs and ends of lines around it.
std::string_view trimmed(std::string_view text);

// The parts between commas that no bracket encloses, trimmed: "a[1, 2], b" has two.
std::vector<std::string> items_of(std::string_view text);

} // namespace symreal
