// External functions: the bridges by which some languages call them, and the statements of a call.
#pragma once

#include "engine/emit/print/expression.h"

#include <string>
#include <vector>

namespace symreal {

// The language's integer type for one of C; null if it lacks one.
BridgeInteger const *find_integer(BridgeSyntax const &syntax, std::string_view c);

// Declarations of the called functions, and their bridges.
std::string print_bridge_declarations(Emission const &emission);
std::string print_bridges(Emission const &emission);

// Statements for the call of an external function.
class CallStatement {
public:
  CallStatement(FunctionContext &context, std::size_t statement);

  External const &function() const { return function_; }
  // Array for the results: `v` if a later chunk reads them, else a local one; omitted if no result is read.
  std::string array() const { return is_kept() ? "v" : "r" + std::to_string(statement_); }
  bool has_array() const;

  std::vector<std::string> print() const;

private:
  bool is_kept() const { return context_.kept[call_] != no_slot; }

  FunctionContext &context_;
  std::size_t statement_;
  NodeId call_;
  std::size_t number_; // number of the function in the graph
  External const &function_;
  bool is_wanted_; // the returned value is read
};

} // namespace symreal
