// What a verification says of threads that share an evaluation.
#pragma once

#include "verify/verification.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <ostream>

namespace symreal::tool {

void print_threads(std::ostream &out, program::ThreadResult const &result);
nlohmann::ordered_json to_json(program::ThreadResult const &result);

// Where they compute other numbers than one.
std::optional<Diagnostic> thread_failure(program::Verification const &verification, std::string const &file);

} // namespace symreal::tool
