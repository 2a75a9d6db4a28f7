// Text functions for C and C++ without a parser, and the tokens that they read, from Clang's raw lexer.
#pragma once

#include "engine/support/text.h"

#include <cstddef>
#include <string>
#include <vector>

namespace symreal::rewrite {

struct RawToken {
  enum class Kind : unsigned char { word, literal, comment, other }; // a literal: text, a character, a number
  Kind kind;
  std::size_t begin, end; // in the text
  bool begins_line;       // the first token of its line, comments aside
};

std::vector<RawToken> raw_tokens(std::string const &text);

// Whether the character may stand in an identifier.
bool is_word(char c);

// The parenthesis that closes the one at `open`, literals aside; npos if none does.
std::size_t closing_parenthesis(std::string const &text, std::size_t open);

// The text without comments, each run of white space one blank.
std::string normalised(std::string const &source);

// Whether the text holds nothing but what can stand between a function pragma and the first token of its function:
// comments, other directives, template and linkage headers.
bool only_declaration_start(std::string const &source);

// The text with `double` as a whole word replaced by REAL (in its long form, see type_name.h), except in long double.
std::string with_real(std::string const &source);

// Error message for the range of an input with both ends written as numbers; empty if it is right or only the run knows
// the numbers.
std::string wrong_range(std::string const &low, std::string const &high);

// Whether the number is not finite: nan, inf, or too large for a double.
bool is_not_finite(std::string const &number);

// The text without white space at its end.
std::string trimmed(std::string text);

} // namespace symreal::rewrite
