// Texts shared by generated code and reports about it.
#pragma once

#include "engine/emit/language/emitted.h"

namespace symreal {

// The user's text made safe for any language: valid UTF-8, with a blank for each character that ends a line or changes
// the writing direction.
std::string printable(std::string_view text);

// Text without the delimiters of comments.
std::string in_comment(std::string const &text);

// Place with a machine-independent path: a file outside the project (Eigen, std) is elsewhere on every machine.
std::string portable_place(Place place);

// The name with the prefix ("arm_"), if one is given.
std::string prefixed(EmitOptions const &options, std::string const &name);

// Text of a guard's condition, and its places: the user's own first, then those further in.
std::string guard_text(Graph const &graph, Guard const &guard);

} // namespace symreal
