// What a function of a file is called, reads and fills.
#pragma once

#include "emit/print/emission.h"

namespace symreal {

enum class FunctionKind { preprocess, computed_angles, compute };

struct FunctionPlan {
  FunctionBody const &body;
  std::optional<reroll::LoopFunction> const *loops; // of the file, or none has any
  std::string name;
  std::vector<std::string> inputs;
  std::string target;
  bool in_compute; // reads what compute reads
  bool has_angles; // begins with sines and cosines, which its parts read
  bool is_local;   // of the file, not of its interface
};

FunctionPlan function_plan(Emission const &emission, FunctionKind kind);

} // namespace symreal
