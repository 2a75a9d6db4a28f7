// The header beside a generated file in C or C++, held against the recorded kernel: what it declares must be, token by
// token, what generation declares. Comments, blanks and the name of the macro that guards it are free.
#pragma once

#include "engine/graph/graph.h"
#include "verify/generated_code.h"

#include <string>

namespace symreal::program {

// Where it stands.
std::string header_of(std::string const &generated);

// `recorded`: the kernel's graph. False: there is no header. Throws header_differs.
bool require_header(std::string const &generated, Banner const &banner, Graph const &recorded);

} // namespace symreal::program
