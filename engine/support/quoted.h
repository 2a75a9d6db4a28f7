// Text as the literal of a string, as C, YAML and the text of a graph have it.
#pragma once

#include <string>

namespace symreal {

// With a backslash before each quotation mark and each backslash.
std::string escaped(std::string const &text);
// The same between quotation marks.
std::string in_quotes(std::string const &text);

} // namespace symreal
