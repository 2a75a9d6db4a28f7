// Printing of a loop program: a local function for each step, and a function that calls them.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/function_plan.h"

namespace symreal {

CodeText print_loops(Emission &emission, reroll::LoopFunction const &function, FunctionPlan const &plan);

} // namespace symreal
