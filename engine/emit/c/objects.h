// The annotated objects in C and C++: where each begins in the array of its role, and members for a struct of doubles.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

struct ObjectTexts {
  std::string indices; // enumerators, each on a line of its own; empty where there is no number
  std::string members;
};

ObjectTexts c_objects(Emission const &emission, std::string const &role, std::vector<Object> const &objects);

// The macro that keeps a header from being read twice.
std::string include_guard(Emission const &emission, std::string const &suffix);

} // namespace symreal
