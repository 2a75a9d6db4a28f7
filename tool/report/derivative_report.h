// What a verification says of derivatives.
#pragma once

#include "program/derivative_verification.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <ostream>

namespace symreal::tool {

void print_derivatives(std::ostream &out, program::DerivativeResult const &result);
nlohmann::ordered_json to_json(program::DerivativeResult const &result);

// Where they are wrong, or where too few samples can tell.
std::optional<Diagnostic> derivative_failure(program::DerivativeResult const &result, std::string const &file);

} // namespace symreal::tool
