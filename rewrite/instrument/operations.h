// Which operation of the table a function of the C library or an intrinsic of LLVM is.
#pragma once

#include <llvm/ADT/StringRef.h>
#include <symreal/op.h>

#include <optional>

namespace symreal::oracle {

struct Operation {
  Op op;
  unsigned arity;
};

// By the name of a function of the C library, such as "sin".
std::optional<Operation> operation_of_function(llvm::StringRef name);
// By that of an intrinsic on doubles, such as "llvm.fabs.f64".
std::optional<Operation> operation_of_intrinsic(llvm::StringRef name);

} // namespace symreal::oracle
