// The parts of generated C, one function each; those that C++ has as well are used there.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

std::string c_begin(Emission const &emission);
std::string c_header(Emission const &emission);
std::string c_mainline(Emission const &emission);

// Gateways for MATLAB and Octave, and for Simulink.
std::string c_mex(Emission const &emission);
std::string c_simulink(Emission const &emission);

// How C and C++ differ in a program that runs the kernel once.
struct MainlineWords {
  std::string header, includes;
  std::string scope; // before the names of the interface
};
std::string mainline(Emission const &emission, MainlineWords const &words);

// The integer functions that the kernel's functions call, and their includes.
std::string c_integer_functions(Emission const &emission);
std::string c_integer_includes(Emission const &emission);

// With guards only: the function that gives their texts, and its name with what it takes.
std::string c_guard_text(Emission const &emission);
// What stands behind the functions.
std::string c_end(Emission const &emission);

// The index lists of matrices of derivatives: declared in C's header and defined in its source, and defined in C++'s
// header.
std::string c_matrices(Emission const &emission);
std::string c_matrix_lists(Emission const &emission);
std::string cpp_matrices(Emission const &emission);

// What reports values that are not finite, where they are checked.
std::string c_value_checks(Emission const &emission);

// Whatever the flags, nothing is fused; empty in mode fast.
std::string c_no_fusion(Emission const &emission);
std::string c_quiet_pragmas(Emission const &emission);
// That sine and cosine only compute, where there are both of one angle.
std::string c_sine_and_cosine(Emission const &emission);
// The function that computes sines and cosines side by side.
std::string c_sines_and_cosines(Emission const &emission);
// With vectors: their type, and how they are loaded and stored.
std::string c_vectors(Emission const &emission);
// A word for functions that compilers must not inline, where there are such.
std::string c_apart(Emission const &emission);

} // namespace symreal
