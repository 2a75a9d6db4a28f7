#include "rewrite/pragma/externals.h"

#include "rewrite/source/walk.h"

#include <algorithm>

namespace symreal::rewrite {
namespace {

using namespace clang;

// Calls with effects that the language lets happen in either order: the symbolic program need not have them in the
// order of the original.
class Order : public Walk {
public:
  Order(SourceMap const &map, Facts &facts, Reals const &reals) : map_(map), facts_(facts), reals_(reals) {}

  bool VisitBinaryOperator(BinaryOperator *binary) override {
    if (!binary->isLogicalOp() && !binary->isCommaOp())
      check({binary->getLHS(), binary->getRHS()}, binary->getOperatorLoc());
    return true;
  }
  bool VisitCallExpr(CallExpr *call) override {
    check({call->arg_begin(), call->arg_end()}, call->getBeginLoc());
    return true;
  }

private:
  class Effects : public Walk {
  public:
    explicit Effects(Reals const &reals) : reals_(reals) {}
    bool TraverseLambdaExpr(LambdaExpr *) override { return true; }
    bool VisitCallExpr(CallExpr *call) override {
      FunctionDecl const *function = call->getDirectCallee();
      Reals::External const *external = function ? reals_.external(function) : nullptr;
      found = found || (external && !external->pure);
      return !found;
    }
    bool found = false;

  private:
    Reals const &reals_;
  };

  void check(std::vector<Expr *> const &operands, SourceLocation location) {
    int count = 0;
    for (Expr *operand : operands) {
      Effects effects(reals_);
      effects.TraverseStmt(operand);
      count += effects.found;
    }
    if (count < 2 || !map_.in_roots(location)) return;
    facts_.diagnostics.push_back({DiagnosticId::external_function,
                                  map_.place(location),
                                  "the language does not say which of these external functions is called first",
                                  {{{}, "put the calls into statements of their own, or say that they are pure"}}});
  }

  SourceMap const &map_;
  Facts &facts_;
  Reals const &reals_;
};

} // namespace

void refuse_unordered_effects(ASTContext &context, SourceMap const &map, PragmaIndex const &index, Facts &facts,
                              Reals const &reals) {
  if (std::none_of(index.externals.begin(), index.externals.end(), [](auto const &pragma) { return !pragma.pure; }))
    return;
  for (Decl *declaration : context.getTranslationUnitDecl()->decls())
    if (map.in_roots(declaration->getLocation())) Order(map, facts, reals).TraverseDecl(declaration);
}

} // namespace symreal::rewrite
