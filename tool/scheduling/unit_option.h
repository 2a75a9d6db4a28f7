// --units: how many units there are, and of which kinds.
#pragma once

#include "engine/analysis/scheduling/timetable.h"
#include "tool/scheduling/task_input.h"

namespace symreal::tool {

struct NamedUnits {
  Units units;
  std::vector<std::string> name; // per unit
};

// "4", or for a recorded graph "mul=2,arithmetic=1,other=1". A kind is an operation, a group of operations, or `other`;
// an operation is of the first of these that is listed. Sets the kinds of the tasks. Throws bad_option and no_unit.
NamedUnits read_units(std::string const &words, Time communication, TaskInput &input);

} // namespace symreal::tool
