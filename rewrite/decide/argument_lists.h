// Propagation of variadic argument lists: functions that read numbers take REALs, all others carried values.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

// Follows the lists from the functions that receive them to those that read them. A list that leaves the sources with a
// REAL in it is a diagnostic.
void follow_argument_lists(Facts &facts, Result &result);

// Whether the function reads numbers, or passes its list to one that does; after follow_argument_lists.
bool reads_numbers(Facts const &facts, std::string const &function);

} // namespace symreal::rewrite
