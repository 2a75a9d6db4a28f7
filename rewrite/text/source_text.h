// C and C++ as text, where there is no parser.
#pragma once

#include "engine/support/quoted.h"

#include <cstddef>
#include <string>

namespace symreal::rewrite {

// May it stand in an identifier?
bool is_word(char c);

// The parenthesis that closes the one at `open`, literals aside; npos if none does.
std::size_t closing_parenthesis(std::string const &text, std::size_t open);

// Comments away, each run of white space one blank.
std::string normalised(std::string const &source);

// Does the text hold nothing but what can stand between a function pragma and the first token of its function:
// comments, other directives, template and linkage headers?
bool only_declaration_start(std::string const &source);

// `double` as a whole word becomes REAL (in its long form, see type_name.h), unless it is a long double.
std::string with_real(std::string const &source);

// What is wrong with the range of an input, where both ends are written as numbers; empty: nothing, or only the run
// knows the numbers.
std::string wrong_range(std::string const &low, std::string const &high);

// Is this a number that is not finite: nan, inf, or one that no double holds?
bool is_not_finite(std::string const &number);

// The text without white space at its end.
std::string trimmed(std::string text);

} // namespace symreal::rewrite
