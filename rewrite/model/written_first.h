// Static integers of a function that it writes before it reads them, on all paths: their values never pass from one
// call to the next.
#pragma once

#include "rewrite/source/clang.h"

namespace symreal::rewrite {

class WrittenFirst {
public:
  // Whether no path through the variable's function reads it before an assignment, and its address does not leave the
  // expressions that read or write it. Scalars only.
  //
  // Method: a forward data-flow analysis of definite assignment on Clang's control-flow graph.
  bool holds(clang::VarDecl const *variable);
  // Whether that is likely: an element counts as the array, a member as the structure, a call that takes the address as
  // an assignment, and each loop runs. The recorded path then decides; otherwise another call of the function, or a
  // holder of the address, reads a value left by an earlier call.
  bool is_likely(clang::VarDecl const *variable);

private:
  llvm::DenseMap<clang::VarDecl const *, bool> known_, likely_;
};

} // namespace symreal::rewrite
