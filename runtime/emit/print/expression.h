// Expressions in C: nested as far as the schedule nests them, parenthesised no more than needed.
#pragma once

#include "emit/print/variable_names.h"

#include <string>

namespace symreal {

// A double as a C constant that reads back to the same bits.
std::string c_constant(double value);

// How the nodes that stand in an array are spelled inside one function.
struct FunctionContext {
  bool in_compute;                                   // reads input[] and constants[]; otherwise parameters[]
  std::vector<std::uint32_t> const *name;            // per node: the number of its variable, or no_slot
  VariableNames const *spelling;                     // of variables
  std::vector<std::uint32_t> const *kept = nullptr;  // per node: the slot of v[] where an earlier chunk kept it
  std::vector<NodeId> *spelled_out = nullptr;        // takes the operations that an expression holds
  std::vector<char> const *constant_paths = nullptr; // per node; null: compilers may evaluate what they find constant
};

// The value of `root`, spelled out even where the node has a variable (it is the statement that sets it).
std::string c_expression(Schedule const &plan, FunctionContext const &context, NodeId root);
// A condition in C that holds where the literal does. A comparison is negated, not turned round: with a NaN both x < y
// and x >= y are false.
std::string c_condition(Schedule const &plan, FunctionContext const &context, Literal literal);
// A use of the node: its variable, its array element or its constant; a nested expression is spelled out.
std::string c_use(Schedule const &plan, FunctionContext const &context, NodeId node);

} // namespace symreal
