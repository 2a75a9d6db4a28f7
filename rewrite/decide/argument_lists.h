// What goes through `...`: a function that reads it as numbers takes REALs, any other their carried values.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

// Follows the lists from the functions that have them to those that read them. A list that leaves the sources with a
// REAL in it is a diagnostic.
void follow_argument_lists(Facts &facts, Result &result);

// Afterwards: is the function one that reads numbers, or hands its list to one?
bool reads_numbers(Facts const &facts, std::string const &function);

} // namespace symreal::rewrite
