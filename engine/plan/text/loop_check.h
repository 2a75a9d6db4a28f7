// Soundness of a function's loops: each step reads what is stored before, elements lie in their arrays, and all results
// are stored. Values are not compared: passes may have changed bodies in ways that only real numbers permit.
#pragma once

#include "engine/plan/plan.h"

#include <string>

namespace symreal {

// The first thing that is wrong with the loops of a function; empty if they are sound.
std::string find_fault(Plan const &plan, PlanFunction const &function);

} // namespace symreal
