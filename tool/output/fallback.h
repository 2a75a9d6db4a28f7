// What a wrapper does where the generated code is not the original: it calls that, which the user provides under
// another name.
#pragma once

#include "rewrite/rewrite.h"

#include <string>

namespace symreal::tool {

struct Fallback {
  std::string declaration; // of the original under the name `name`
  std::string statement;   // calls it with the wrapper's arguments and returns
  std::string way;         // how the original gets the name
};

// A plain function is compiled under another name; the symbol of any other (in a namespace, a member, overloaded) is
// renamed in its object file, and called as a function of C linkage.
Fallback fallback(rewrite::Kernel const &kernel, std::string const &name);

} // namespace symreal::tool
