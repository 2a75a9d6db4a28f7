// The parts of generated C++ that differ from C, one function each.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

// The namespace of a kernel: the prefix, or the kernel's name.
std::string cpp_namespace(std::string const &kernel, std::string const &prefix);
inline std::string cpp_namespace(Emission const &emission) {
  return cpp_namespace(emission.graph().kernel, emission.options.prefix);
}

std::string cpp_begin(Emission const &emission);
std::string cpp_external_declarations(Emission const &emission);
std::string cpp_open(Emission const &emission);
std::string cpp_end(Emission const &emission);
std::string cpp_header(Emission const &emission);
std::string cpp_mainline(Emission const &emission);

} // namespace symreal
