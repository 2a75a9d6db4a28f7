// The functions of complex numbers (include/symreal/complex_functions.def) as external functions of a graph. They take
// the parts of their operands one by one and write those of their result, and everybody can call them.
#pragma once

#include "engine/graph/external.h"

#include <symreal/complex_function.h>

#include <optional>
#include <span>
#include <string_view>

namespace symreal {

struct ComplexFunctionInfo {
  std::string_view name; // in a graph
  unsigned arity;
  bool is_infix;
  std::string_view c;
  bool has_cut;
};

ComplexFunctionInfo const &info(ComplexFunction function);

External external_of(ComplexFunction function);
std::optional<ComplexFunction> find_complex_function(External const &external);

// The reference semantics: the C library's function, the compiler's operator.
void evaluate(ComplexFunction function, std::span<double const> arguments, std::span<double> results);

} // namespace symreal
