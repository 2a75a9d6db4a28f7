// What a function of a file is called, reads and fills.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

enum class FunctionKind { preprocess, computed_angles, compute };

struct FunctionPlan {
  FunctionBody const &body;
  std::optional<reroll::LoopFunction> const *loops; // of the file, or none has any
  std::string name;
  std::vector<std::string> inputs, part_inputs; // of the function, of its parts
  std::string target;
  bool in_compute; // reads what compute reads
  bool is_local;   // of the file, not of its interface

  // Whether it begins with sines and cosines, which its parts read.
  bool has_angles() const { return part_inputs.size() != inputs.size(); }
};

FunctionPlan function_plan(Emission const &emission, FunctionKind kind);

} // namespace symreal
