// Words on a bisection: the pass, the rewrite and the place that make an output differ.
#pragma once

#include "program/record/record.h"
#include "verify/generated_code.h"
#include "verify/verification.h"

#include <string>

namespace symreal::tool {

// Finds the pass by the default pipeline, on the worst sample of the first output that differs.
std::string bisected(program::Recorded const &recorded, program::Banner const &banner,
                     program::Verification const &verification, program::VerificationOptions const &options);

} // namespace symreal::tool
