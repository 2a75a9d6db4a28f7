// A walk over what evaluating an expression or a statement computes: no operands of sizeof, no bodies of lambdas.
#pragma once

#include "rewrite/clang.h"

namespace symreal::rewrite {

template <class Derived> class EvaluatedWalk : public clang::RecursiveASTVisitor<Derived> {
public:
  bool shouldVisitImplicitCode() const { return true; }
  bool TraverseLambdaExpr(clang::LambdaExpr *) { return true; }
  bool TraverseUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr *) { return true; }
  bool TraverseCXXNoexceptExpr(clang::CXXNoexceptExpr *) { return true; }
  bool TraverseTypeLoc(clang::TypeLoc) { return true; }
};

} // namespace symreal::rewrite
