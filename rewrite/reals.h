// Which types and expressions become REAL in the symbolic program, and which stay double.
#pragma once

#include "rewrite/clang.h"
#include "rewrite/source_map.h"

#include <map>
#include <string>

namespace symreal::rewrite {

class Reals {
public:
  explicit Reals(SourceMap const &map) : map_(map) {}

  static bool is_double(clang::QualType type);

  // Would an object of this type hold a REAL in itself or in the storage that it owns (a container's elements)?
  bool carries_real(clang::QualType type) const;

  // The same, looking through pointers, references and function types.
  bool mentions_real(clang::QualType type) const;

  // Does an expression of arithmetic type keep its type in the symbolic program: a literal, arithmetic on literals, the
  // result of a function outside the roots, a constexpr variable?
  bool stays_double(clang::Expr const *expression) const;

  // A double now, a REAL in the symbolic program.
  bool is_real(clang::Expr const *expression) const {
    return is_double(expression->getType()) && !expression->isTypeDependent() && !stays_double(expression);
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

  bool in_roots(clang::Decl const *declaration) const { return map_.in_roots(declaration->getLocation()); }

  // A function of <math.h> or <cmath>, for which the runtime has an overload.
  bool is_math(clang::FunctionDecl const *function) const;
  static bool is_math_name(llvm::StringRef name);

  // What the function was before its template parameters were replaced.
  static clang::FunctionDecl const *pattern(clang::FunctionDecl const *function);

  // Templates of the standard library that count in plain numbers: random distributions, chrono.
  static bool is_passive_template(clang::NamedDecl const *declaration);
  static bool is_passive_class(clang::QualType type);

private:
  enum class Depth { storage, anything };
  bool holds(clang::QualType type, Depth depth, llvm::SmallPtrSetImpl<clang::Type const *> &seen) const;
  bool call_stays_double(clang::CallExpr const *call) const;
  bool object_is_passive(clang::Expr const *expression) const;

  SourceMap const &map_;
  std::map<clang::FunctionDecl const *, External> externals_;
};

} // namespace symreal::rewrite
