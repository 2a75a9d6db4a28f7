// Encoding of a name in the facts that both the program and the C library define. A function or variable with external
// linkage is renamed in all sources if one defines it; else it is the library's.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

// Entry of Facts::definitions; with a file, for a name of internal linkage.
inline std::string definition_of(std::string const &name, std::string const &file = {}) {
  return "own name " + name + " " + file;
}

inline bool is_defined(Facts const &facts, Wrap const &own_name) {
  return facts.definitions.contains(definition_of(own_name.detail)) ||
         facts.definitions.contains(definition_of(own_name.detail, own_name.span.file));
}

} // namespace symreal::rewrite
