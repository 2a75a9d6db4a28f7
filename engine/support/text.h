// Text: blanks trimmed, items between commas, string literals as C, YAML and the text form of a graph write them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// The text without surrounding blanks, tabs and newlines.
std::string_view trimmed(std::string_view text);

// The trimmed parts between commas outside brackets: "a[1, 2], b" has two.
std::vector<std::string> items_of(std::string_view text);

// The text with a backslash before each quotation mark and backslash.
std::string escaped(std::string const &text);
// The escaped text in quotation marks.
std::string in_quotes(std::string const &text);
// The text as a document in XML or HTML shows it, also within an attribute.
std::string escaped_xml(std::string_view text);

} // namespace symreal
