// Which function each line of a C or C++ source stands in, as far as its text tells: what a graph does not say.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace symreal::tool {

struct FunctionLines {
  std::string name; // "dot", "Robot::inverse"
  unsigned first, last;
};

// In the order of the text; none within another. Reads braces, not C++: where macros hide braces it finds fewer.
std::vector<FunctionLines> function_lines(std::string_view text);

} // namespace symreal::tool
