// Where an expression's object lives, as far as the source tells: in the function itself, or somewhere that may outlive
// the kernel. The recording judges by addresses; what is certainly local need not be looked at.
#pragma once

#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"

namespace symreal::rewrite {

enum class Home {
  local,     // a variable of the function, or what such a container owns
  elsewhere, // behind a pointer or reference, in *this, of static storage duration
  constant,  // a const object of static storage duration
};

class Storage {
public:
  explicit Storage(Reals const &reals) : reals_(reals) {}

  Home home(clang::Expr const *expression) const;

  // The reference at the base of a name's members and elements, or null.
  static clang::Expr const *base(clang::Expr const *expression);

  // An object of the class lets others' numbers be seen, such as Eigen's Map and Block.
  static bool is_view(clang::QualType type);

  // The object that a call is made on, if it is a member's.
  static clang::Expr const *object_of(clang::CallExpr const *call);
  // A container of a library that holds its elements itself.
  static bool owns_elements(clang::QualType type);
  // It gives elements of others, and holds none: a view, a std::initializer_list.
  static bool lends(clang::QualType type);
  // Does an object hold pointers or references to objects? A container's own to its elements do not count.
  static bool holds_pointer(clang::QualType type);
  // An expression that leads from the variable to objects that are no part of it: the variable where it is a pointer or
  // holds one, an address where it is a reference; empty where none is known.
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

// Is there such a type among the arguments of the template, those of a pack included?
bool any_type_argument(clang::ClassTemplateSpecializationDecl const *special,
                       llvm::function_ref<bool(clang::QualType)> is_one);

// Does the function return one of its arguments?
bool selects_argument(clang::FunctionDecl const *function);

// Without what has no spelling of its own, and without parentheses.
clang::Expr const *spelled_expression(clang::Expr const *expression);

} // namespace symreal::rewrite
