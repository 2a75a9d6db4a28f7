// Facts as text (JSON with comments) and back, so that decisions on them can be tested without Clang.
//
// A struct is an object of its members; a member that has the value of a struct just made is left out. A map is a list
// of pairs, a use or clause its name, another enumeration its number, and flags by offset are the lengths of their
// runs, the first of those that do not hold.
#pragma once

#include "rewrite/facts/facts.h"

#include <string>

namespace symreal::rewrite {

std::string to_text(Facts facts);

// Throws std::invalid_argument with the error and its place.
Facts facts_of_text(std::string const &text);

} // namespace symreal::rewrite
