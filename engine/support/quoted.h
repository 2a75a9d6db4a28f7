// String literals as C, YAML and the text form of a graph write them.
#pragma once

#include <string>

namespace symreal {

// The text with a backslash before each quotation mark and backslash.
std::string escaped(std::string const &text);
// The escaped text in quotation marks.
std::string in_quotes(std::string const &text);

} // namespace symreal
