// What a graph, or an option, wants of a language.
#pragma once

#include "emit/language/emitted.h"
#include "emit/language/language.h"
#include "schedule/schedule.h"

namespace symreal {

// Throws bad_option where the language's table leaves it out.
void require_expressible(Schedule const &plan, Language const &language, EmitOptions const &options);

} // namespace symreal
