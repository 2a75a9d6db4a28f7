// The statements of a wrapper: from the objects of the program to the flat arrays of generated code, and back.
#pragma once

#include "graph/graph.h"
#include "rewrite/rewrite.h"

#include <functional>
#include <string>

namespace symreal::program {

// symreal_input, symreal_parameters, symreal_constants and symreal_output, of at least one element each.
std::string wrapper_arrays(Graph const &graph);

// `kind`: "input" or "parameter"; the array is written.
std::string wrapper_pack(rewrite::Kernel const &kernel, std::string_view kind, std::vector<Object> const &objects,
                         std::string_view array);

// From symreal_output. `returned`: the statement that returns a value, if the kernel has that as an output.
using ReturnStatement = std::function<std::string(rewrite::Annotation const &annotation, std::string const &value)>;
std::string wrapper_unpack(rewrite::Kernel const &kernel, std::vector<Object> const &objects,
                           ReturnStatement const &returned);

} // namespace symreal::program
