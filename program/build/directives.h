// The text of a source of C or C++ as its preprocessor sees it, as far as that can be told without running it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace symreal::program {

// A word of the source outside of comments and literals.
struct Identifier {
  std::size_t begin, end;
  std::string text;
};

struct Directive {
  std::size_t begin;   // the number sign
  std::string keyword; // define, if, ...
  std::vector<Identifier> identifiers;
};

struct Directives {
  std::vector<Directive> directives;
  std::vector<Identifier> identifiers; // of the whole text, but for names of files that are included
};

Directives read_directives(std::string const &text);

} // namespace symreal::program
