// Walk over the evaluated parts of an expression or a statement, without operands of sizeof and bodies of lambdas.
#pragma once

#include "rewrite/source/clang.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {

class EvaluatedWalk : public Walk {
public:
  bool shouldVisitImplicitCode() const override { return true; }
  bool TraverseLambdaExpr(clang::LambdaExpr *) override { return true; }
  bool TraverseUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr *) override { return true; }
  bool TraverseCXXNoexceptExpr(clang::CXXNoexceptExpr *) override { return true; }
  bool TraverseTypeLoc(clang::TypeLoc) override { return true; }
};

} // namespace symreal::rewrite
