// Preprocessing directives and identifiers of a C or C++ source, as far as they are determined without preprocessing.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace symreal::program {

// An identifier outside comments and literals.
struct Identifier {
  std::size_t begin, end;
  std::string text;
};

struct Directive {
  std::size_t begin;   // offset of the number sign
  std::string keyword; // define, if, ...
  std::vector<Identifier> identifiers;
};

struct Directives {
  std::vector<Directive> directives;
  std::vector<Identifier> identifiers; // of the whole text, except names of included files
};

Directives read_directives(std::string const &text);

} // namespace symreal::program
