// What a line of YAML should be where an array section or a pattern stands in it without quotes.
#pragma once

#include <string>

namespace symreal::tool {

// `inputs: ["q[0:6]", "v"]` for `inputs: [q[0:6], v]`; `exclude: "*.cpp"` for `exclude: *.cpp`. Empty where nothing in
// the line wants quotes.
std::string with_quotes(std::string const &line);

} // namespace symreal::tool
