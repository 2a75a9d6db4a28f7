// Names and arrays of a function in a generated file.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

enum class FunctionKind { preprocess, computed_angles, compute };

struct FunctionPlan {
  FunctionBody const &body;
  std::optional<reroll::LoopFunction> const *loops; // null if the file has no loops
  std::string name;
  std::vector<std::string> inputs, part_inputs; // parameters of the function, and of its parts
  std::string target;
  bool in_compute; // it reads what compute reads
  bool is_local;   // local to the file, rather than part of its interface

  // Whether the function begins with sines and cosines, which its parts read.
  bool has_angles() const { return part_inputs.size() != inputs.size(); }
};

FunctionPlan function_plan(Emission const &emission, FunctionKind kind);

} // namespace symreal
