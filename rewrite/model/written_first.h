// Static integers of a function that it writes before it reads them, whichever way it takes: what a call leaves in them
// reaches no other call.
#pragma once

#include "rewrite/source/clang.h"

namespace symreal::rewrite {

class WrittenFirst {
public:
  // Whether no path through the variable's function reads it before an assignment, and its address does not leave
  // the expressions that read or write it. Only scalars are looked at.
  //
  // Method: a forward data-flow analysis of definite assignment on Clang's control-flow graph.
  bool holds(clang::VarDecl const *variable);
  // Whether that may well be: an element counts as the array, a member as the structure, a call that is given the
  // address as an assignment, and each loop runs. Then the recorded path tells; otherwise another call of the function
  // reads what a call before has left, or somebody to whom the address went.
  bool is_likely(clang::VarDecl const *variable);

private:
  llvm::DenseMap<clang::VarDecl const *, bool> known_, likely_;
};

} // namespace symreal::rewrite
