// Identification of the math library that programs call: glibc selects the code of its functions by processor, and
// results differ in the last bit.
#pragma once

#include <string>

namespace symreal {

// Name such as "glibc 2.36, code for processors with FMA (c65ae37e)". It is derived from sample results, so other
// selections of code, such as by GLIBC_TUNABLES, show as well; the digits are a hash of these results.
std::string math_library();

} // namespace symreal
