// The parts of generated C, one function each; C++ shares some of them.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

std::string c_begin(Emission const &emission);
// Includes, pragmas and definitions before the functions.
std::string c_preamble(Emission const &emission);
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

// Declarations of the external functions that the kernel calls. Parameters are declared as the doubles that they
// consist of, by which a program passes structs and arrays of doubles.
std::string c_external_declarations(Emission const &emission);

std::vector<std::string> c_call(ExternalCall const &call);

// A C file with a wrapper per external function, with flat arrays of arguments and results:
//   void symreal_call_<number>(double const *argument, double *result);
std::string c_external_calls(Graph const &graph);

// Annotated objects: offsets in the array of their role, and members of a struct of doubles.
struct ObjectTexts {
  std::string indices; // enumerators, one per line; empty if the role has no elements
  std::string members;
};

ObjectTexts c_objects(Emission const &emission, std::string const &role, std::vector<Object> const &objects);

// The include guard's macro.
std::string include_guard(Emission const &emission, std::string const &suffix);

// Number of guards and declaration of the function that returns their texts, in headers; empty without guards.
std::string c_guard_list(Emission const &emission);

// Index lists of matrices of derivatives, in headers (C declares them, C++ defines them), and their
// definitions in C's source.
std::string c_matrices(Emission const &emission);
std::string c_matrix_lists(Emission const &emission);

// Function that computes sines and cosines in one vectorisable loop.
std::string c_sines_and_cosines(Emission const &emission);

} // namespace symreal
