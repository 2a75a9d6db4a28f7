// The type of a pragma's item that stands before a function, where the compiler does not look at it.
//
//   item    := ("*" | "&") item | primary { "." name | "->" name | "[" ... "]" | "(" ... ")" }
//   primary := name { "::" name } | "this" | "(" item ")"
#pragma once

#include "rewrite/source/clang.h"

namespace symreal::rewrite {

struct ItemType {
  clang::QualType type;   // of each element; null where it is not known
  bool is_packed = false; // a member that may lie anywhere
};

// `look_up` finds the declaration behind a name that nothing qualifies.
ItemType type_of_item(std::string const &expression, clang::FunctionDecl const *function,
                      llvm::function_ref<clang::ValueDecl const *(std::string const &)> look_up);

// The same of an item that the compiler has looked at.
ItemType type_of_item(clang::Expr const *expression);

} // namespace symreal::rewrite
