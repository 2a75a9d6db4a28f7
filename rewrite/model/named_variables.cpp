#include "rewrite/model/named_variables.h"

#include "rewrite/model/storage.h"
#include "rewrite/source/evaluated_walk.h"

namespace symreal::rewrite {
using namespace clang;

class NamedUses : public EvaluatedWalk {
public:
  NamedUses(NamedVariableAnalysis &analysis, NamedVariables &found, bool with_locals)
      : analysis_(analysis),
        found_(found),
        with_locals_(with_locals) {}

  bool VisitImplicitCastExpr(ImplicitCastExpr *cast) override {
    if (cast->getCastKind() == CK_LValueToRValue) add(found_.read, cast->getSubExpr());
    return true;
  }
  bool VisitBinaryOperator(BinaryOperator *binary) override {
    if (binary->isAssignmentOp()) add(found_.changed, binary->getLHS());
    return true;
  }
  bool VisitUnaryOperator(UnaryOperator *unary) override {
    if (unary->isIncrementDecrementOp()) add(found_.changed, unary->getSubExpr());
    return true;
  }
  bool VisitCallExpr(CallExpr *call) override {
    if (FunctionDecl const *function = call->getDirectCallee()) {
      NamedVariables const &within = analysis_.of(function);
      found_.changed.insert(within.changed.begin(), within.changed.end());
      found_.read.insert(within.read.begin(), within.read.end());
    }
    return true;
  }

private:
  void add(llvm::SmallPtrSet<VarDecl const *, 4> &variables, Expr const *object) {
    auto const *name = dyn_cast_or_null<DeclRefExpr>(Storage::base(object));
    auto const *variable = name ? dyn_cast<VarDecl>(name->getDecl()) : nullptr;
    if (!variable || variable->getType()->isPointerType() || variable->getType()->isReferenceType()) return;
    if (with_locals_ || variable->hasGlobalStorage()) variables.insert(variable->getCanonicalDecl());
  }

  NamedVariableAnalysis &analysis_;
  NamedVariables &found_;
  bool with_locals_;
};

bool NamedVariables::meet(NamedVariables const &other) const {
  auto const among = [](auto const &variables) {
    return [&variables](VarDecl const *one) { return variables.contains(one); };
  };
  return llvm::any_of(changed, among(other.changed)) || llvm::any_of(changed, among(other.read)) ||
         llvm::any_of(read, among(other.changed));
}

NamedVariables NamedVariableAnalysis::of(Expr const *expression) {
  NamedVariables found;
  NamedUses(*this, found, true).TraverseStmt(const_cast<Expr *>(expression));
  return found;
}

NamedVariables const &NamedVariableAnalysis::of(FunctionDecl const *function) {
  FunctionDecl const *definition = nullptr;
  bool const is_seen = function->isDefined(definition) && definition->getBody();
  auto const [at, is_new] = functions_.try_emplace(is_seen ? definition : function); // empty for a call of itself
  if (is_new && is_seen) {
    NamedVariables found;
    NamedUses(*this, found, false).TraverseStmt(definition->getBody());
    at->second = std::move(found);
  }
  return at->second;
}

} // namespace symreal::rewrite
