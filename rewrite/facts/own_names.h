// How the facts say that the program has a name of its own that the C library has too. A function or variable that
// other sources know is renamed in all of them if one defines it; else it is the library's.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

// Among Facts::definitions; with a file, of what no other source knows.
inline std::string definition_of(std::string const &name, std::string const &file = {}) {
  return "own name " + name + " " + file;
}

inline bool is_defined(Facts const &facts, Wrap const &own_name) {
  return facts.definitions.contains(definition_of(own_name.detail)) ||
         facts.definitions.contains(definition_of(own_name.detail, own_name.span.file));
}

} // namespace symreal::rewrite
