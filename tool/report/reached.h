// What a scan tells of one function: what it reaches, and what of that stands in the way of a kernel or depends on
// values.
#pragma once

#include "rewrite/facts/result.h"
#include "rewrite/unit/reach.h"

#include <ostream>
#include <string>

namespace symreal::tool {

void print_reach(std::ostream &out, std::string const &function, rewrite::Reach const &reach,
                 rewrite::Result const &result);

} // namespace symreal::tool
