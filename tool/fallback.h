// What a wrapper does where a guard does not hold: it calls the original, which the user compiles under another name.
#pragma once

#include "rewrite/rewrite.h"

#include <string>

namespace symreal::tool {

struct Fallback {
  std::string declaration; // of the original under the name `name`
  std::string statement;   // calls it with the wrapper's arguments and returns
};

// Fails for a function whose declaration cannot be repeated under another name: a member, a template, one in a
// namespace, one with variable arguments.
Fallback fallback(rewrite::Kernel const &kernel, std::string const &name);

} // namespace symreal::tool
