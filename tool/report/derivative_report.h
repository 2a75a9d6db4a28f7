// Report on the verification of derivatives.
#pragma once

#include "verify/verification.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace symreal::tool {

// Inputs of a sample for a message: the first 16.
std::string number_list(std::vector<double> const &values);

void print_derivatives(std::ostream &out, program::DerivativeResult const &result);
nlohmann::ordered_json to_json(program::DerivativeResult const &result);
// Reads the result for a kernel with `outputs` outputs of its own. Throws what nlohmann::json throws.
program::DerivativeResult derivatives_of(nlohmann::ordered_json const &json, std::size_t outputs);

// Diagnostic for derivatives that are wrong, or that too few samples judge.
std::optional<Diagnostic> derivative_failure(program::DerivativeResult const &result, std::string const &file,
                                             bool is_whole);

} // namespace symreal::tool
