// Tokens of C and C++ text, from Clang's raw lexer, which needs no parser and no source manager.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace symreal::rewrite {

struct RawToken {
  enum class Kind : unsigned char { word, literal, comment, other }; // a literal: text, a character, a number
  Kind kind;
  std::size_t begin, end; // in the text
  bool begins_line;       // the first token of its line, comments aside
};

// Calls `take` for each token from `begin` on, until it returns false.
void for_raw_tokens(std::string const &text, std::size_t begin, std::function<bool(RawToken const &)> const &take);
std::vector<RawToken> raw_tokens(std::string const &text);

} // namespace symreal::rewrite
