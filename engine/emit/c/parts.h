// The parts of generated C, one function each; C++ shares some of them.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

std::string c_begin(Emission const &emission);
std::string c_header(Emission const &emission);
std::string c_mainline(Emission const &emission);

// Gateways for MATLAB and Octave, and for Simulink.
std::string c_mex(Emission const &emission);
std::string c_simulink(Emission const &emission);

// Differences between C and C++ in a program that runs the kernel once.
struct MainlineWords {
  std::string header, includes;
  std::string scope; // qualifier of the interface names
};
std::string mainline(Emission const &emission, MainlineWords const &words);

// Integer functions that the kernel's functions call, and their includes.
std::string c_integer_functions(Emission const &emission);
std::string c_integer_includes(Emission const &emission);

// Function that returns the texts of guards, if there are guards.
std::string c_guard_text(Emission const &emission);
// Code after the kernel's functions.
std::string c_end(Emission const &emission);

// Index lists of matrices of derivatives: the declarations for C's header, the definitions for C's source, and those
// for C++'s header.
std::string c_matrices(Emission const &emission);
std::string c_matrix_lists(Emission const &emission);
std::string cpp_matrices(Emission const &emission);

// Function that reports values that are not finite, if they are checked.
std::string c_value_checks(Emission const &emission);

// Pragmas that forbid fusion under any compiler flags; empty in mode fast.
std::string c_no_fusion(Emission const &emission);
std::string c_quiet_pragmas(Emission const &emission);
// Declarations of sine and cosine as pure functions, if the kernel has both of one angle.
std::string c_sine_and_cosine(Emission const &emission);
// Function that computes sines and cosines in one vectorisable loop.
std::string c_sines_and_cosines(Emission const &emission);
// Vector type, and functions that load and store vectors, if there are vectors.
std::string c_vectors(Emission const &emission);
// Macro for functions that compilers must not inline, if there are such.
std::string c_apart(Emission const &emission);

} // namespace symreal
