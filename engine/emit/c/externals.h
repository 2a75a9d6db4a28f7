// External functions in C. Verification calls them by themselves.
#pragma once

#include "engine/emit/print/emission.h"

#include <string>
#include <vector>

namespace symreal {

// A declaration of each function that is called. Parameters are declared by what they consist of, doubles; that is how
// a program passes structs and arrays of doubles.
std::string c_external_declarations(Emission const &emission);

std::vector<std::string> c_call(ExternalCall const &call);

// A C file with a function for each external one, which takes its arguments and gives its results as flat arrays:
//   void symreal_call_<number>(double const *argument, double *result);
std::string c_external_calls(Graph const &graph);

} // namespace symreal
