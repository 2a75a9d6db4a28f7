// The result of a verification, for the user.
#pragma once

#include "verify/verification.h"

#include <optional>
#include <ostream>

namespace symreal::tool {

// The worst distance per output.
void print_verification(std::ostream &out, Graph const &graph, program::Verification const &verification);

// Why the verification has failed, if it has.
std::optional<Diagnostic> verification_failure(Graph const &graph, program::Verification const &verification,
                                               program::VerificationOptions const &options, std::string const &file);

} // namespace symreal::tool
