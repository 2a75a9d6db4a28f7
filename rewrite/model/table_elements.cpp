#include "rewrite/model/table_elements.h"

#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

class Writes : public Walk {
public:
  explicit Writes(SourceMap const &map) : map_(map) {}

  std::set<Span> found;

  bool VisitImplicitCastExpr(ImplicitCastExpr *cast) override {
    if (cast->getCastKind() == CK_LValueToRValue) parts(cast->getSubExpr());
    return true;
  }
  bool VisitArraySubscriptExpr(ArraySubscriptExpr *element) override { return element_of(element); }
  bool VisitCXXOperatorCallExpr(CXXOperatorCallExpr *element) override { return element_of(element); }

private:
  // A parent is visited before its parts, and a row is a part of its element.
  Expr const *parts(Expr const *element) {
    std::vector<Expr const *> indices;
    element = element->IgnoreParenImpCasts();
    while (Expr const *whole = subscripted(element, indices)) {
      known_.insert(element);
      element = whole;
    }
    return element;
  }

  bool element_of(Expr const *element) {
    if (known_.contains(element)) return true;
    Expr const *whole = parts(element);
    if (whole == element || !map_.in_roots(whole->getBeginLoc()) || !map_.is_shared(whole->getSourceRange()))
      return true;
    if (std::optional<Span> const span = map_.range(whole->getSourceRange())) found.insert(*span);
    return true;
  }

  SourceMap const &map_;
  llvm::SmallPtrSet<Expr const *, 16> known_;
};

} // namespace

Expr const *subscripted(Expr const *expression, std::vector<Expr const *> &indices) {
  expression = expression->IgnoreParenImpCasts();
  if (auto const *subscript = dyn_cast<ArraySubscriptExpr>(expression)) {
    if (subscript->isTypeDependent() || subscript->getBase() != subscript->getLHS()) return nullptr; // 2[tab]
    indices.push_back(subscript->getIdx());
    return subscript->getBase()->IgnoreParenImpCasts();
  }
  auto const *call = dyn_cast<CXXOperatorCallExpr>(expression);
  if (!call || call->getOperator() != OO_Subscript || call->getNumArgs() != 2) return nullptr;
  auto const *record = call->getArg(0)->getType()->getAsCXXRecordDecl();
  if (!record || !record->isInStdNamespace() || !record->getIdentifier()) return nullptr;
  if (record->getName() != "array" && record->getName() != "vector") return nullptr;
  indices.push_back(call->getArg(1));
  return call->getArg(0)->IgnoreParenImpCasts();
}

std::set<Span> shared_and_written(ASTContext &context, SourceMap const &map) {
  Writes writes(map);
  for (Decl *declaration : context.getTranslationUnitDecl()->decls())
    if (map.in_roots(declaration->getLocation()) || map.in_roots(declaration->getBeginLoc()))
      writes.TraverseDecl(declaration);
  return std::move(writes.found);
}

} // namespace symreal::rewrite
