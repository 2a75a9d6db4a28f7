// The enumeration of the functions in complex_functions.def.
#pragma once

#include <cstdint>

namespace symreal {

enum class ComplexFunction : std::uint8_t {
#define COMPLEX_FUNCTION(id, ...) id,
#include <symreal/complex_functions.def>
#undef COMPLEX_FUNCTION
};

} // namespace symreal
