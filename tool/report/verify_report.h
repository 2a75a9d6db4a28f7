// Report on a verification.
#pragma once

#include "verify/verification.h"

#include <optional>
#include <ostream>

namespace symreal::tool {

// Prints the worst distance of each output.
void print_verification(std::ostream &out, Graph const &graph, program::Verification const &verification);

// Diagnostic for a failed verification; nullopt if it succeeded.
std::optional<Diagnostic> verification_failure(Graph const &graph, program::Verification const &verification,
                                               program::VerificationOptions const &options, std::string const &file);

} // namespace symreal::tool
