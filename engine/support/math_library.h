// Which mathematical library a program of this process would call: glibc chooses the code of its functions by the
// processor, and results differ in the last bit.
#pragma once

#include <string>

namespace symreal {

// "glibc 2.36, code for processors with FMA (c65ae37e)": by what the functions give at some numbers, so that what
// chooses another code, as GLIBC_TUNABLES, shows as well. The digits are of all these results.
std::string math_library();

} // namespace symreal
