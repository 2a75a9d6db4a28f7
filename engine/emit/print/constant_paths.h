// Where a compiler may find that a call of the C library has constant arguments, and compute it itself.
//
// It rounds correctly then, and the library does not always: cbrt(1.5) differs in the last bit. Calls of constants are
// not in the graph, as they are folded with the library's values. But gcc and clang look along each path: in
// cbrt(c ? 1.5 : x), or where x == 1.5 holds, one call is one of a constant.
#pragma once

#include "engine/graph/graph.h"

#include <span>
#include <vector>

namespace symreal {

// Per node: whether it is a number that does not depend on the input on some path.
// `inputs`: per slot, whether it is one of these itself.
std::vector<char> constant_on_a_path(Graph const &graph, std::vector<char> const &inputs = {});
// Whether some argument is hidden.
bool hides_arguments(Graph const &graph);

// The operand of a call that the generated code must hide from the compiler; no_node where none.
NodeId hidden_operand(Graph const &graph, std::vector<char> const &constant_on_a_path, Node const &call);
NodeId hidden_argument(Graph const &graph, std::vector<char> const &constant_on_a_path,
                       std::span<NodeId const> arguments);

} // namespace symreal
