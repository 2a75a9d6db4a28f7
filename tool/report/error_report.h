// Report on the errors of the original and of the generated code against exact values.
#pragma once

#include "engine/graph/graph.h"
#include "verify/exact_errors.h"

#include <nlohmann/json_fwd.hpp>

#include <ostream>

namespace symreal::tool {

void print_errors(std::ostream &out, Graph const &graph, program::ErrorResult const &result);
nlohmann::ordered_json to_json(program::ErrorResult const &result);
// Reads the result. Throws what nlohmann::json throws for a member that is missing or of another type.
program::ErrorResult errors_of(nlohmann::ordered_json const &json, std::size_t outputs);

} // namespace symreal::tool
