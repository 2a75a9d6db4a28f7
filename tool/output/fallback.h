// Fallback of a wrapper to the original, which the user provides under another name, on calls that the generated code
// does not cover.
#pragma once

#include "rewrite/rewrite.h"

#include <string>

namespace symreal::tool {

struct Fallback {
  std::string declaration; // declares the original as `name`
  std::string statement;   // calls it with the wrapper's arguments and returns
  std::string way;         // instructions for renaming the original
};

// A plain function is compiled under another name; for any other (in a namespace, a member, overloaded), the symbol in
// the object file is renamed and called with C linkage.
Fallback fallback(rewrite::Kernel const &kernel, std::string const &name);

} // namespace symreal::tool
