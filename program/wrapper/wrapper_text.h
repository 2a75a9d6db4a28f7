// Statements of a wrapper, which convert between the program's objects and the flat arrays of generated code.
#pragma once

#include "engine/graph/graph.h"
#include "rewrite/rewrite.h"

#include <functional>
#include <string>
#include <vector>

namespace symreal::program {

// The text as a translation unit has it once, though several of its files begin with it. `macro`: says that it was
// there.
std::string once(std::string const &macro, std::string const &text);

// Is the kernel's source, and so its wrapper, in C?
bool is_c(rewrite::Kernel const &kernel);

// Declares symreal_input and symreal_output, with at least one element each; symreal_parameters if there are any.
std::string wrapper_arrays(Graph const &graph);

// Packs objects into the array. `kind`: "input" or "parameter".
std::string wrapper_pack(rewrite::Kernel const &kernel, std::string_view kind, std::vector<Object> const &objects,
                         std::string_view array);

// Unpacks symreal_output. `returned`: gives the return statement if the kernel outputs its return value; an object is
// constructed before it, of the function's own type. Throws no_wrapper if that is impossible.
using ReturnStatement = std::function<std::string(std::string const &value)>;
std::string wrapper_unpack(rewrite::Kernel const &kernel, std::vector<Object> const &objects,
                           ReturnStatement const &returned);

// Ends the program on a call other than the recorded one, in wrappers without an original to call.
std::string refusal_of(std::string const &label);

// Checks of extents that may differ from the recorded call: condition of a difference, and the object.
struct ExtentCheck {
  std::string differs, label;
};
std::vector<ExtentCheck> wrapper_extents(rewrite::Kernel const &kernel, Graph const &graph);

// Address range of an object's numbers, as two arguments; `in_rows`: of its first row. Empty if the object has no
// numbers.
std::string wrapper_place(rewrite::Kernel const &kernel, Graph const &graph, std::string const &label, bool in_rows);
// Objects, as the source names them, whose extents the wrapper checks in the call.
std::vector<std::string> wrapper_containers(rewrite::Kernel const &kernel, Graph const &graph);

// Templates for objects of a C++ kernel other than arrays: containers, matrices, complex numbers. Blocks of C++11 in
// lines without directives; empty if unused.
std::vector<std::string> wrapper_templates(rewrite::Kernel const &kernel, Graph const &graph);

} // namespace symreal::program
