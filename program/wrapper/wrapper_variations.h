// Variations of the recorded call that a wrapper must notice, since they change what the recording bakes in: other
// values, other extents, overlapping arguments.
#pragma once

#include "program/record/front.h"

#include <string>
#include <vector>

namespace symreal::program {

// Statements that turn the recorded call into such a call. Classes, and data that only templates reach, stay.
struct Variation {
  std::string where;       // description, behind "the original"
  std::string statement;   // runs once the arguments have their numbers
  std::string before = {}; // runs at the function's begin
};
std::vector<Variation> wrapper_variations(Recorded const &recorded);

// Functions that the statements call, in one line.
std::string variation_helpers(Recorded const &recorded);

} // namespace symreal::program
