// Expressions in a language: nested as far as the schedule nests them, parenthesised no more than needed.
#pragma once

#include "engine/emit/language/prepared_pattern.h"
#include "engine/emit/print/emission.h"
#include "engine/emit/print/variable_names.h"

#include <algorithm>
#include <string>
#include <vector>

namespace symreal {

// A few names, each once.
class ArrayNames {
public:
  void insert(std::string_view name) {
    if (!contains(name)) names_.push_back(name);
  }
  bool contains(std::string_view name) const { return std::ranges::find(names_, name) != names_.end(); }

private:
  std::vector<std::string_view> names_;
};

// What is still to be printed of an expression: text, or a node that needs parentheses unless it binds at least this
// tightly.
struct ExpressionItem {
  // What stands at a place of the text: a number, a truth value, or the node as it is. `converted`: a number of the
  // language's type of numbers, also where truth values count as integers.
  enum class As : std::uint8_t { number, truth, itself, converted };

  std::string_view text = {};
  NodeId node = no_node;
  int binding = binding::loosest;
  As as = As::itself;
  bool spelled_out = false; // even if it has a variable
};

// How the nodes that stand in variables and arrays are spelled inside one function, and what its text has used.
struct FunctionContext {
  Emission &emission;
  FunctionBody const &body;
  bool in_compute;                        // reads input and constants; otherwise parameters
  VariableNames spelling;                 // of variables
  std::vector<std::uint32_t> variable;    // per node: the number of its variable, or no_slot
  std::vector<std::uint32_t> kept;        // per node: the element of v where it stands for later chunks, or no_slot
  std::vector<std::uint32_t> copied = {}; // per node: the element of v that has its array's element; or empty
  std::vector<char> constant_paths;       // per node; empty: compilers may evaluate what they find constant
  ArrayNames arrays = {};                 // that the text names
  std::vector<NodeId> spelled_out = {};   // the operations that the text holds
  std::vector<std::string> leaves = {};   // per input: how it is spelled where it is no element of `input`
  std::vector<ExpressionItem> items = {}; // of the expressions that are being printed, the next one last

  FunctionContext(Emission &emission, FunctionBody const &body, bool in_compute);
  Graph const &graph() const { return emission.graph(); }
  bool is_gate(NodeId id) const { return body.regions.is_gate(id); }
  // An element of an array that the function has or is given.
  void append_element(std::string &text, std::string_view array, std::size_t index);
  // The element of an array of results that a call sets: its own array, or v.
  std::string result_element(NodeId call, std::size_t result);

private:
  PreparedPattern element_;
};

// At the end of `text` the value of `root`, spelled out even where the node has a variable (it is the statement that
// sets it).
void print_expression(FunctionContext &context, NodeId root, std::string &text);
// A condition that holds where the literal does. A comparison is negated, not turned round: with a NaN both x < y
// and x >= y are false.
std::string print_condition(FunctionContext &context, Literal literal);
// That one of the alternatives of a gate holds: all literals of one of them.
std::string print_gate(FunctionContext &context, NodeId gate);
// A use of the node as a number or an integer: its variable, its array element or its constant; a nested expression is
// spelled out.
void print_use(FunctionContext &context, NodeId node, std::string &text);
std::string print_use(FunctionContext &context, NodeId node);
// As a function or a list of numbers takes it.
std::string print_argument(FunctionContext &context, NodeId node);

} // namespace symreal
