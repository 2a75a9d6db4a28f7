// --units: number and kinds of units.
#pragma once

#include "engine/analysis/scheduling/timetable.h"
#include "tool/scheduling/task_input.h"

namespace symreal::tool {

struct NamedUnits {
  Units units;
  std::vector<std::string> name; // per unit
};

// Reads "4", or for a recorded graph "mul=2,arithmetic=1,other=1". A kind is an operation, a group, or `other`; an
// operation takes the first of these that is listed. Sets the tasks' kinds. Throws bad_option and no_unit.
NamedUnits read_units(std::string const &words, Time communication, TaskInput &input);

} // namespace symreal::tool
