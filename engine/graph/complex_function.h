// Functions of complex numbers (include/symreal/complex_functions.def) as external functions of a graph. Arguments and
// results are lists of real and imaginary parts; every evaluator can call them.
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

// Reference semantics: the C library's functions and the compiler's operators.
void evaluate(ComplexFunction function, std::span<double const> arguments, std::span<double> results);

} // namespace symreal
