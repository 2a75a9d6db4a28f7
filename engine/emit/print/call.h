// The call of an external function as statements.
#pragma once

#include "engine/emit/print/expression.h"

namespace symreal {

class CallStatement {
public:
  CallStatement(FunctionContext &context, std::size_t statement);

  External const &function() const { return function_; }
  // The array that takes the results: v where later chunks read them, else one of the call's own, unless nobody reads
  // any.
  std::string array() const { return is_kept() ? "v" : "r" + std::to_string(statement_); }
  bool has_array() const;

  std::vector<std::string> print() const;

private:
  bool is_kept() const { return context_.kept[call_] != no_slot; }

  FunctionContext &context_;
  std::size_t statement_;
  NodeId call_;
  std::size_t number_; // of the function
  External const &function_;
  bool is_wanted_; // somebody reads the returned value
};

} // namespace symreal
