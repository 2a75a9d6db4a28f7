// Correction of YAML lines in which an array section or a pattern lacks quotes.
#pragma once

#include <string>

namespace symreal::tool {

// `inputs: ["q[0:6]", "v"]` for `inputs: [q[0:6], v]`; `exclude: "*.cpp"` for `exclude: *.cpp`. Empty if the line needs
// no quotes.
std::string with_quotes(std::string const &line);

} // namespace symreal::tool
