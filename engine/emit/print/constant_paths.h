// Constant paths: library calls whose arguments a compiler may find constant, and evaluate itself.
//
// A compiler rounds correctly, the library not always: cbrt(1.5) differs in the last bit. The graph has no calls of
// constants, since they are folded with the library's values. But gcc and clang analyse each path: in
// cbrt(c ? 1.5 : x), or where x == 1.5 holds, a call has a constant argument.
#pragma once

#include "engine/graph/graph.h"

#include <span>
#include <vector>

namespace symreal {

// Per node: whether it is a number that on some path is independent of the input.
// `inputs`: per slot, whether the input itself counts as one.
std::vector<char> constant_on_a_path(Graph const &graph, std::vector<char> const &inputs = {});
// Whether the generated code must hide an argument.
bool hides_arguments(Graph const &graph);

// Operand of a call that the generated code must hide from the compiler; no_node if all may be seen.
NodeId hidden_operand(Graph const &graph, std::vector<char> const &constant_on_a_path, Node const &call);
NodeId hidden_argument(Graph const &graph, std::vector<char> const &constant_on_a_path,
                       std::span<NodeId const> arguments);

} // namespace symreal
