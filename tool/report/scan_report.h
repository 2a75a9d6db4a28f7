// Reports of a scan: share of the sources that converts, obstacles, and dependences on values; and what one function
// reaches.
#pragma once

#include "rewrite/facts/result.h"
#include "rewrite/rewrite.h"
#include "rewrite/unit/reach.h"

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>

namespace symreal::tool {

// Prints the report; with `list`, every place.
void print_readiness(std::ostream &out, rewrite::Request const &request, rewrite::Result const &result, bool list);
nlohmann::ordered_json readiness_json(rewrite::Request const &request, rewrite::Result const &result);

// SARIF 2.1.0: obstacles, and dependences on values.
nlohmann::ordered_json sarif(rewrite::Result const &result);

// Prints what the function reaches, the obstacles to a kernel there, and the dependences on values.
void print_reach(std::ostream &out, std::string const &function, rewrite::Reach const &reach,
                 rewrite::Result const &result);

} // namespace symreal::tool
