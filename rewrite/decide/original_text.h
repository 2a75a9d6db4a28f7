// What pragmas become in the program that verification runs as the original: annotations that its own language has, and
// nothing else (<symreal/original.h>).
#pragma once

#include "rewrite/facts/facts.h"

#include <string>

namespace symreal::rewrite {

// The annotations of a region pragma, on one line.
std::string original_region_text(PragmaFact const &pragma);

// What stands right after the brace of a function with a pragma.
std::string original_function_text(PragmaFact const &pragma);

// The file with its annotations alone; nothing where it has none.
std::vector<Edit> original_edits(Facts const &facts, std::string const &path);

} // namespace symreal::rewrite
