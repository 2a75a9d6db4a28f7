// Texts of pragmas in the program that verification runs as the original: annotations in its own language, and nothing
// else (<symreal/original.h>).
#pragma once

#include "rewrite/facts/facts.h"

#include <string>

namespace symreal::rewrite {

// The annotations of a region pragma, on one line.
std::string original_region_text(PragmaFact const &pragma);

// Text to insert after the opening brace of a function with a pragma.
std::string original_function_text(PragmaFact const &pragma);

// Edits that only add annotations to the file; empty without annotations.
std::vector<Edit> original_edits(Facts const &facts, std::string const &path);

} // namespace symreal::rewrite
