// Check of a graph and the options against the features of a language.
#pragma once

#include "engine/emit/language/emitted.h"
#include "engine/emit/language/language.h"
#include "engine/plan/schedule/schedule.h"

namespace symreal {

// Throws bad_option if the language lacks a feature that the graph or an option requires.
void require_expressible(Schedule const &plan, Language const &language, EmitOptions const &options);

} // namespace symreal
