// Classification of types and expressions: those that become REAL in the symbolic program, and those that stay double.
#pragma once

#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <map>
#include <string>

namespace symreal::rewrite {

class Reals {
public:
  explicit Reals(SourceMap const &map) : map_(map) {}

  static bool is_double(clang::QualType type);

  // Whether an object of this type holds a REAL in itself or in the storage that it owns (a container's elements).
  bool carries_real(clang::QualType type) const;

  // Like carries_real, looking through pointers, references and function types.
  bool mentions_real(clang::QualType type) const;

  // Whether an expression of arithmetic type keeps its type in the symbolic program: a literal, arithmetic on literals,
  // the result of a function outside the roots, a constexpr variable.
  bool stays_double(clang::Expr const *expression) const;

  // A double now, a REAL in the symbolic program.
  bool is_real(clang::Expr const *expression) const {
    return is_double(expression->getType()) && !expression->isTypeDependent() &&
           (!stays_double(expression) || computes_with_counted(expression));
  }

  // constexpr, a static const member with its value in the class, or declared outside the roots.
  bool is_passive(clang::VarDecl const *variable) const;

  // A function that stays as it is and whose calls are recorded.
  struct External {
    std::string arguments; // of the macro around it, behind its name
    bool pure;
  };
  void add_external(clang::FunctionDecl const *function, External external) {
    externals_[function->getCanonicalDecl()] = std::move(external);
  }
  External const *external(clang::FunctionDecl const *function) const {
    auto const found = externals_.find(function->getCanonicalDecl());
    return found == externals_.end() ? nullptr : &found->second;
  }

  // Pointee, as spelled, of a pointer or of an array that decays to one; null for any other expression.
  static clang::QualType pointee(clang::Expr const *expression);

  // Integers that keep their dependency, as the class SymbolicInt (symbolic_ints.h).
  static bool is_integer(clang::QualType type);
  // Integer expression behind conversions between integers and nodes without text.
  static clang::Expr const *spelled_integer(clang::Expr const *expression);
  void add_symbolic_integer(clang::VarDecl const *variable) { symbolic_integers_.insert(variable); }
  bool is_symbolic_integer(clang::VarDecl const *variable) const { return symbolic_integers_.contains(variable); }
  bool is_symbolic_integer(clang::Expr const *expression) const;
  // An integer that may be of that class by what it is computed from: conversions, truth values of REALs that are
  // counted. True in doubt.
  bool may_be_symbolic(clang::Expr const *expression) const;
  // Whether the integer depends on a REAL, given which conversions do.
  bool integer_depends(clang::Expr const *expression,
                       llvm::function_ref<bool(clang::CastExpr const *)> cast_does) const;
  // lround and its like, whose result is symbolic.
  bool rounds_to_integer(clang::FunctionDecl const *function) const;
  // A conversion whose spelling keeps its result symbolic.
  void keep_integer(clang::CastExpr const *cast) { kept_casts_.insert(cast); }
  bool keeps_integer(clang::CastExpr const *cast) const { return kept_casts_.contains(cast); }
  // An element read at a symbolic index, with its array; null for any other expression.
  void add_table_load(clang::Expr const *element, clang::Expr const *table) { table_loads_[element] = table; }
  clang::Expr const *table_of(clang::Expr const *element) const { return table_loads_.lookup(element->IgnoreParens()); }

  bool in_roots(clang::Decl const *declaration) const { return map_.in_roots(declaration->getLocation()); }

  // A function of <math.h> or <cmath>, for which the runtime has an overload.
  bool is_math(clang::FunctionDecl const *function) const;
  static bool is_math_name(llvm::StringRef name);
  // Whether a function of C is declared by the program itself and not defined.
  static bool is_declared_math(clang::FunctionDecl const *function);

  // The template pattern that the function was instantiated from.
  static clang::FunctionDecl const *pattern(clang::FunctionDecl const *function);

  // Templates of the standard library that count in plain numbers: random distributions, chrono.
  static bool is_passive_template(clang::NamedDecl const *declaration);
  static bool is_passive_class(clang::QualType type);

private:
  enum class Depth { storage, anything };
  bool holds(clang::QualType type, Depth depth, llvm::SmallPtrSetImpl<clang::Type const *> &seen) const;
  bool call_stays_double(clang::CallExpr const *call) const;
  // Arithmetic in double, of which an operand is converted from an integer or a truth value of a class.
  bool computes_with_counted(clang::Expr const *expression) const;
  bool is_truth_of_numbers(clang::Expr const *expression) const;
  bool object_is_passive(clang::Expr const *expression) const;

  SourceMap const &map_;
  std::map<clang::FunctionDecl const *, External> externals_;
  llvm::SmallPtrSet<clang::VarDecl const *, 8> symbolic_integers_;
  llvm::SmallPtrSet<clang::CastExpr const *, 8> kept_casts_;
  llvm::DenseMap<clang::Expr const *, clang::Expr const *> table_loads_;
};

} // namespace symreal::rewrite
