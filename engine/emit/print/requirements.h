// What a graph, or an option, wants of a language.
#pragma once

#include "engine/emit/language/emitted.h"
#include "engine/emit/language/language.h"
#include "engine/plan/schedule/schedule.h"

namespace symreal {

// Throws bad_option where the language's table leaves it out.
void require_expressible(Schedule const &plan, Language const &language, EmitOptions const &options);

} // namespace symreal
