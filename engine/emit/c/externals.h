// External functions in C, for the kernel and, as separate wrappers, for verification.
#pragma once

#include "engine/emit/print/emission.h"

#include <string>
#include <vector>

namespace symreal {

// Declarations of the called functions. Parameters are declared as the doubles that they consist of, by which a program
// passes structs and arrays of doubles.
std::string c_external_declarations(Emission const &emission);

std::vector<std::string> c_call(ExternalCall const &call);

// A C file with a wrapper per external function, with flat arrays of arguments and results:
//   void symreal_call_<number>(double const *argument, double *result);
std::string c_external_calls(Graph const &graph);

} // namespace symreal
