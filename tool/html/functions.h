// Map from lines of C or C++ source to functions, which the graph lacks, as far as the text tells.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace symreal::tool {

struct FunctionLines {
  std::string name; // "dot", "Robot::inverse"
  unsigned first, last;
};

// Functions in text order, not nested. Reads braces, not C++: finds fewer functions if macros hide braces.
std::vector<FunctionLines> function_lines(std::string_view text);

} // namespace symreal::tool
