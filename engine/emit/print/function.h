// Printing of a plan's functions: a single walk over statements and blocks for all languages. Vectors and loops, which
// replace the statements, are printed in lanes.cpp and loops.cpp.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/emission.h"

#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// Prints a function; a long one as local functions that the last one calls.
CodeText print_function(Emission &emission, PlanFunction const &function);

// Names of a function and its arrays in a generated file.
struct FunctionNames {
  std::string name;
  std::vector<std::string> inputs, part_inputs; // parameters of the function, and of its parts
  std::string target;

  // Whether the function begins with sines and cosines, which its parts read.
  bool has_angles() const { return part_inputs.size() != inputs.size(); }
};

struct Parameter {
  std::string_view pattern; // of the language
  std::string name;
  bool is_used = true;
};

struct FunctionHead {
  std::string name;
  std::string target = {}; // array that the function fills
  bool may_fail = false, is_pure = false, is_apart = false, is_side_by_side = false;
};

// Appends a function, or a part of a long one, with its head and end to `out`. Parameters that the text does not use
// are marked, against compiler warnings. `pattern`: the language's pattern for the head.
void append_function(Language const &language, std::string_view pattern, FunctionHead const &head,
                     std::vector<Parameter> const &parameters, CodeText &&text, CodeText &out);

// Declares and fills arrays `sine` and `cosine`, if there are angles. Reads array `input`, and for computed angles also
// `constants`.
void print_angles(Emission const &emission, CodeText &out);

// Prints a function's vectors: vector statements interleaved with scalar ones.
CodeText print_lanes(Emission &emission, PlanFunction const &function, FunctionNames const &names);

// Prints a function's loops: a local function for each step, and a function that calls them.
CodeText print_loops(Emission &emission, PlanFunction const &function, FunctionNames const &names);

} // namespace symreal
