// Annotated objects in C and C++: offsets in the array of their role, and members of a struct of doubles.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

struct ObjectTexts {
  std::string indices; // enumerators, one per line; empty if the role has no elements
  std::string members;
};

ObjectTexts c_objects(Emission const &emission, std::string const &role, std::vector<Object> const &objects);

// The include guard's macro.
std::string include_guard(Emission const &emission, std::string const &suffix);

} // namespace symreal
