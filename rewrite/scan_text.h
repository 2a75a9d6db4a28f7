// Steps through C and C++ as text, where there is no parser: over words, literals and parentheses.
#pragma once

#include <cstddef>
#include <string>

namespace symreal::rewrite {

// May it stand in an identifier?
bool is_word(char c);

// One past the string or character literal that begins there, or the end of the text.
std::size_t end_of_literal(std::string const &text, std::size_t begin);

// The parenthesis that closes the one at `open`, literals aside; npos if none does.
std::size_t closing_parenthesis(std::string const &text, std::size_t open);

} // namespace symreal::rewrite
