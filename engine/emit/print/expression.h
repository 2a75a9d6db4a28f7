// Expressions in a language: nested as the plan nests them, with the fewest parentheses.
#pragma once

#include "engine/emit/print/emission.h"

#include <algorithm>
#include <string>
#include <vector>

namespace symreal {

// A small set of names.
class ArrayNames {
public:
  void insert(std::string_view name) {
    if (!contains(name)) names_.push_back(name);
  }
  bool contains(std::string_view name) const { return std::ranges::find(names_, name) != names_.end(); }

private:
  std::vector<std::string_view> names_;
};

// A pending item of an expression: text, or a node that needs parentheses unless it binds at least this tightly.
struct ExpressionItem {
  // Form of the node: a number, a truth value, or the node as it is. `converted`: a number of the language's real type,
  // even if truth values count as integers.
  enum class As : std::uint8_t { number, truth, itself, converted };

  std::string_view text = {};
  NodeId node = no_node;
  int binding = binding::loosest;
  As as = As::itself;
  bool spelled_out = false; // even if the node has a variable
};

// Spellings of nodes in variables and arrays within one function, and the names that its text uses.
struct FunctionContext {
  Emission &emission;
  PlanFunction const &body;
  VariableNames spelling;                 // of variables
  std::vector<std::uint32_t> variable;    // per node: number of its variable, or no_slot
  std::vector<std::uint32_t> kept;        // per node: element of v that keeps it for later chunks, or no_slot
  std::vector<std::uint32_t> copied = {}; // per node: element of v with a copy of its array element; or empty
  std::vector<char> constant_paths;       // per node; empty: compilers may fold operations on constants
  ArrayNames arrays = {};                 // used in the text
  std::vector<NodeId> spelled_out = {};   // operations in the text
  std::vector<std::string> leaves = {};   // per input: its spelling, if it differs from an element of `input`
  std::vector<ExpressionItem> items = {}; // pending items of the printed expressions, the next one last

  FunctionContext(Emission &emission, PlanFunction const &body);
  Graph const &graph() const { return emission.graph(); }
  bool is_gate(NodeId id) const { return body.regions.is_gate(id); }
  ValueKind kind(NodeId id) const { return emission.plan.kind(body, id); }
  // Appends an element of a local or parameter array.
  void append_element(std::string &text, std::string_view array, std::size_t index);
  // Element of the array that a call stores its results in: its own array, or v.
  std::string result_element(NodeId call, std::size_t result);

private:
  PreparedPattern element_;
};

// Appends the value of `root` to `text`, as an expression even if the node has a variable (for the statement that sets
// it).
void print_expression(FunctionContext &context, NodeId root, std::string &text);
// Condition equivalent to the literal. A comparison is negated instead of reversed: with a NaN both x < y and x >= y
// are false.
std::string print_condition(FunctionContext &context, Literal literal);
// Condition of a gate: all literals of at least one alternative hold.
std::string print_gate(FunctionContext &context, NodeId gate);
// Use of the node as a number or an integer: its variable, array element or constant, or its nested expression.
void print_use(FunctionContext &context, NodeId node, std::string &text);
std::string print_use(FunctionContext &context, NodeId node);
// Use of the node as a function's argument, or in a list of numbers.
std::string print_argument(FunctionContext &context, NodeId node);

} // namespace symreal
