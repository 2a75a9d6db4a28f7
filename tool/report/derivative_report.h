// Report on the verification of derivatives.
#pragma once

#include "verify/verification.h"

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace symreal::tool {

// Inputs of a sample for a message: the first 16.
std::string number_list(std::vector<double> const &values);

// Name of element k of the derivatives.
std::string name_of(program::DerivativeResult const &result, std::size_t k);

void print_derivatives(std::ostream &out, program::DerivativeResult const &result);

// Diagnostic for derivatives that are wrong, or that too few samples judge.
std::optional<Diagnostic> derivative_failure(program::DerivativeResult const &result, std::string const &file,
                                             bool is_whole);

} // namespace symreal::tool
