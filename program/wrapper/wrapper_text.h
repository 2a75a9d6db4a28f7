// The statements of a wrapper: from the objects of the program to the flat arrays of generated code, and back.
#pragma once

#include "engine/graph/graph.h"
#include "rewrite/rewrite.h"

#include <functional>
#include <string>
#include <vector>

namespace symreal::program {

// Is the kernel's source in C, and its wrapper so too?
bool is_c(rewrite::Kernel const &kernel);

// symreal_input and symreal_output, of at least one element each; symreal_parameters where there are any.
std::string wrapper_arrays(Graph const &graph);

// `kind`: "input" or "parameter"; the array is written.
std::string wrapper_pack(rewrite::Kernel const &kernel, std::string_view kind, std::vector<Object> const &objects,
                         std::string_view array);

// From symreal_output. `returned`: the statement that returns a value, if the kernel has that as an output. An object
// is made before it, of the function's own type. Throws no_wrapper where none can be.
using ReturnStatement = std::function<std::string(std::string const &value)>;
std::string wrapper_unpack(rewrite::Kernel const &kernel, std::vector<Object> const &objects,
                           ReturnStatement const &returned);

// Ends the program where another call than the recorded one has no original to go to.
std::string refusal_of(std::string const &label);

// The extents that may be others in another call than in the recorded one: what is true then, and the object.
struct ExtentCheck {
  std::string differs, label;
};
std::vector<ExtentCheck> wrapper_extents(rewrite::Kernel const &kernel, Graph const &graph);

// From where to where the numbers of an object lie, as two arguments; `in_rows`: those of its first row. Empty where it
// has none.
std::string wrapper_place(rewrite::Kernel const &kernel, Graph const &graph, std::string const &label, bool in_rows);
// The objects whose extents the wrapper asks in the call, as the source names them.
std::vector<std::string> wrapper_containers(rewrite::Kernel const &kernel, Graph const &graph);

// What the statements of a kernel in C++ use where an object is more than an array: a container, a matrix, a complex
// number. Blocks of C++11 in lines without directives; none where nothing uses them.
std::vector<std::string> wrapper_templates(rewrite::Kernel const &kernel, Graph const &graph);

} // namespace symreal::program
