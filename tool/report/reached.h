// Report of a scan on one function: what it reaches, the obstacles to a kernel there, and the dependences on values.
#pragma once

#include "rewrite/facts/result.h"
#include "rewrite/unit/reach.h"

#include <ostream>
#include <string>

namespace symreal::tool {

void print_reach(std::ostream &out, std::string const &function, rewrite::Reach const &reach,
                 rewrite::Result const &result);

} // namespace symreal::tool
