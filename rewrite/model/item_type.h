// The type of a pragma's item that stands before a function, where the compiler does not look at it.
//
//   item    := ("*" | "&") item | primary { "." name | "->" name | "[" ... "]" | "(" ... ")" }
//   primary := name { "::" name } | "this" | "(" item ")"
#pragma once

#include "rewrite/source/clang.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace symreal::rewrite {

// Finds the declaration behind a name that nothing qualifies.
using LookUp = llvm::function_ref<clang::ValueDecl const *(std::string const &)>;

// A pair of brackets in an item, and the object that it takes elements of.
struct ItemIndex {
  std::size_t object, open, close;   // offsets in the item: where the object begins, '[' and ']'
  bool is_unbounded = false;         // behind a pointer, or an array that may go on behind its declared end
  std::optional<std::int64_t> count; // how many elements a declaration says that there are
};

struct ItemType {
  clang::QualType type;                // of each element; null if unknown
  bool is_packed = false;              // a member that may lie anywhere
  std::vector<ItemIndex> indices = {}; // from left to right
};

// Names of other scopes and `this` are unknown without a function.
ItemType type_of_item(std::string const &expression, clang::ASTContext const &context,
                      clang::FunctionDecl const *function, LookUp look_up);

// The value of an expression of integers; nullopt if the declarations alone do not determine it.
std::optional<std::int64_t> constant_of(std::string const &expression, LookUp look_up);

// The type of an item that the compiler has parsed.
ItemType type_of_item(clang::Expr const *expression);

} // namespace symreal::rewrite
