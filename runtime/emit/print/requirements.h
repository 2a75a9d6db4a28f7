// What a graph, or an option, wants of a language.
#pragma once

#include "emit/language/emitted.h"
#include "emit/language/language.h"

namespace symreal {

// Throws bad_option where the language's table leaves it out.
void require_expressible(Graph const &graph, Language const &language, EmitOptions const &options);

} // namespace symreal
