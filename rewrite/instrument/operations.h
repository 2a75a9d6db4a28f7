// Operations of the table for functions of the C library and intrinsics of LLVM.
#pragma once

#include <llvm/ADT/StringRef.h>
#include <symreal/op.h>

#include <optional>

namespace symreal::oracle {

struct Operation {
  Op op;
  unsigned arity;
};

// Operation of a C library function, such as "sin".
std::optional<Operation> operation_of_function(llvm::StringRef name);
// Operation of an intrinsic on doubles, such as "llvm.fabs.f64".
std::optional<Operation> operation_of_intrinsic(llvm::StringRef name);

} // namespace symreal::oracle
