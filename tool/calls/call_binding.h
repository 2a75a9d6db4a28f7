// Binding of a kernel call to its function: the statements that make the call, and the equivalent of a pragma.
#pragma once

#include "rewrite/unit/callables.h"
#include "tool/calls/call_spec.h"

#include <string>
#include <vector>

namespace symreal::tool {

struct CallBinding {
  struct Statement {
    std::string text; // one line
    Place place;      // of the words that it derives from
  };
  std::string before; // declaration at file scope; may be empty
  std::vector<Statement> statements;
  rewrite::ConfiguredKernel kernel;
  std::vector<std::string> unknown;  // names of items that are not arguments
  std::vector<std::string> unvalued; // items without a given value
  std::vector<Diagnostic> problems;  // empty if the function can be called so
};

CallBinding bind_call(CallSpec const &spec, rewrite::Callable const &function);

// Helpers that the statements use, in the language of the source.
std::string binding_helpers(bool is_c);

} // namespace symreal::tool
