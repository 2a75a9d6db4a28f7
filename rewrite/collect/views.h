// Pointers to numbers that are taken for pointers to something else, integers as a rule. The run checks whether one of
// the numbers is symbolic: when the pointer is made, or at the first read through the local variable that holds it.
#pragma once

#include "rewrite/collect/objects.h"

namespace symreal::rewrite {

class Views : public ObjectUses {
public:
  explicit Views(SyntaxTable &table) : ObjectUses(table) {
    on<clang::ImplicitCastExpr>(RUNNING, &Views::loaded);
    on<clang::BinaryOperator>(RUNNING, &Views::assignment);
    on<clang::UnaryOperator>(RUNNING, &Views::step);
  }

  // A cast of a pointer to numbers.
  void view(clang::ExplicitCastExpr const *cast, bool of_integers);
  // A local pointer to bytes that a number shares: true if `part`, a member of a union, goes into one.
  bool view_of_union(clang::Expr const *part);

  void loaded(clang::ImplicitCastExpr const *cast) {
    if (cast->getCastKind() == clang::CK_LValueToRValue && !cast->isTypeDependent()) read_view(cast->getSubExpr());
  }
  void assignment(clang::BinaryOperator const *assignment);
  void step(clang::UnaryOperator const *step);
  void finish() override;

private:
  void read_view(clang::Expr const *value);
  void store_to_view(clang::Expr const *left);
  bool use_of_view(clang::Expr const *value, clang::DeclRefExpr const *name);

  llvm::SmallPtrSet<clang::VarDecl const *, 4> views_;        // local pointers to integers that point to numbers
  llvm::SmallPtrSet<clang::VarDecl const *, 4> views_of_one_; // those that point to a single number
  // Reads and stores that may go through those.
  std::vector<std::pair<clang::Expr const *, clang::DeclRefExpr const *>> through_pointers_, stores_through_;
};

} // namespace symreal::rewrite
