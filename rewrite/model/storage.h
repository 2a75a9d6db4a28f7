// Storage of an expression's object, as far as the source shows: local to the function, or elsewhere, where it may
// outlive the kernel. The recording judges by addresses; certainly local objects need no check.
#pragma once

#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"

namespace symreal::rewrite {

enum class Home {
  local,     // a variable of the function, or elements that it owns
  elsewhere, // behind a pointer or reference, in *this, of static storage duration
  constant,  // a const object of static storage duration
};

class Storage {
public:
  explicit Storage(Reals const &reals) : reals_(reals) {}

  Home home(clang::Expr const *expression) const;

  // The reference at the base of a name's members and elements, or null.
  static clang::Expr const *base(clang::Expr const *expression);

  // Whether objects of the class refer to others' numbers, such as Eigen's Map and Block.
  static bool is_view(clang::QualType type);

  // Object operand of a member call; null for other calls.
  static clang::Expr const *object_of(clang::CallExpr const *call);
  // Whether the class is a library container that holds its elements itself.
  static bool owns_elements(clang::QualType type);
  // Whether the class refers to elements of others: a view, a std::initializer_list.
  static bool lends(clang::QualType type);
  // Whether an object holds pointers or references to objects. A container's own to its elements do not count.
  static bool holds_pointer(clang::QualType type);
  // Expression that leads from the variable to objects outside of it: the variable if it is a pointer or holds one, its
  // address if it is a reference; empty if unknown.
  static std::string lead_from(clang::VarDecl const *variable);

private:
  Home home_of(clang::ValueDecl const *declaration, bool is_captured) const;
  bool leads_to_constant(clang::VarDecl const *variable) const;
  bool target_is_constant(clang::VarDecl const *variable) const;
  Home home_behind(clang::Expr const *pointer) const;
  Home home_of_call(clang::CallExpr const *call) const;

  Reals const &reals_;
  mutable llvm::SmallPtrSet<clang::VarDecl const *, 2> followed_;
};

// Whether the template has such a type among its arguments, those of a pack included.
bool any_type_argument(clang::ClassTemplateSpecializationDecl const *special,
                       llvm::function_ref<bool(clang::QualType)> is_one);

// Whether the function returns one of its arguments.
bool selects_argument(clang::FunctionDecl const *function);

// The expression without parentheses and nodes without text.
clang::Expr const *spelled_expression(clang::Expr const *expression);

} // namespace symreal::rewrite
