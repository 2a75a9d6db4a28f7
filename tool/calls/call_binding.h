// A call of a kernel bound to the function that it calls: the statements that make it, and what else would be a pragma.
#pragma once

#include "rewrite/unit/callables.h"
#include "tool/calls/call_spec.h"

#include <string>
#include <vector>

namespace symreal::tool {

struct CallBinding {
  struct Statement {
    std::string text; // one line
    Place place;      // of the words that it comes from
  };
  std::string before; // a declaration at file scope, or nothing
  std::vector<Statement> statements;
  rewrite::ConfiguredKernel kernel;
  std::vector<std::string> unknown;  // names of items that are no arguments
  std::vector<std::string> unvalued; // items whose values were chosen
  std::vector<Diagnostic> problems;  // none: the function can be called so
};

CallBinding bind_call(CallSpec const &spec, rewrite::Callable const &function);

// What the statements use, in the language of the source.
std::string binding_helpers(bool is_c);

} // namespace symreal::tool
