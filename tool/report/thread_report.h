// Report on the verification of threads that share an evaluation.
#pragma once

#include "verify/verification.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <ostream>

namespace symreal::tool {

void print_threads(std::ostream &out, program::ThreadResult const &result);
nlohmann::ordered_json to_json(program::ThreadResult const &result);

// Diagnostic if they compute other numbers than one thread.
std::optional<Diagnostic> thread_failure(program::Verification const &verification, std::string const &file);

} // namespace symreal::tool
