// Words that stand in generated code and in reports about it.
#pragma once

#include "engine/emit/language/emitted.h"

namespace symreal {

// The user's text as any language may have it: valid UTF-8, in which a blank stands for whatever ends a line or turns
// the direction of writing.
std::string printable(std::string_view text);

// Neither the end of a comment nor its beginning.
std::string in_comment(std::string const &text);

// A file outside of the project (Eigen, std) stands somewhere else on every machine.
std::string portable_place(Place place);

// "arm_" + name, or the bare name.
std::string prefixed(EmitOptions const &options, std::string const &name);

// The condition of a guard in words, and its places: the user's own first, then those further in.
std::string guard_text(Graph const &graph, Guard const &guard);

} // namespace symreal
