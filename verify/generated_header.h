// Check of the header beside a generated C or C++ file against the recorded kernel: its declarations must equal, token
// by token, those that generation writes. Comments, blanks and the name of the include guard may differ.
#pragma once

#include "engine/graph/graph.h"
#include "verify/generated_code.h"

#include <string>

namespace symreal::program {

// Path of the header of a generated file.
std::string header_of(std::string const &generated);

// `recorded`: the kernel's graph. False if the header does not exist. Throws header_differs.
bool require_header(std::string const &generated, Banner const &banner, Graph const &recorded);

} // namespace symreal::program
