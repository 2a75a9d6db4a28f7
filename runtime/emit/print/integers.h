// Integers in C: the functions that the generated file needs for them, and how those of 64 bits stand among doubles.
#pragma once

#include "graph/graph.h"

#include <string>

namespace symreal {

// The headers for what is live, and the functions that the text calls; empty where there are no integers.
std::string c_integer_includes(Graph const &graph);
std::string c_integer_functions(std::string const &text);

std::string c_integer_constant(std::uint64_t value);

// In arrays of doubles an integer of 64 bits is kept by its bits: `element` is such an element.
std::string c_kept_integer(std::string const &element);
std::string c_keep_integer(std::string const &element, std::string const &value);

} // namespace symreal
