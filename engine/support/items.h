// Splitting of text into trimmed items.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// The text without surrounding blanks, tabs and newlines.
std::string_view trimmed(std::string_view text);

// The trimmed parts between commas outside brackets: "a[1, 2], b" has two.
std::vector<std::string> items_of(std::string_view text);

} // namespace symreal
