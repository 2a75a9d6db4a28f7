// Other calls than the recorded one, in which a wrapper must notice what the recording has baked in: other values,
// other extents, two arguments in one place.
#pragma once

#include "program/record/front.h"

#include <string>
#include <vector>

namespace symreal::program {

// Statements that make such a call of the recorded one. Classes, and what only templates reach, stay.
struct Variation {
  std::string where;       // in words, behind "the original"
  std::string statement;   // when the arguments have their numbers
  std::string before = {}; // or when the function begins
};
std::vector<Variation> wrapper_variations(Recorded const &recorded);

// The functions that the statements call, in one line.
std::string variation_helpers(Recorded const &recorded);

} // namespace symreal::program
