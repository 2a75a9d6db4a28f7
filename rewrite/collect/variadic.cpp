// What goes through `...`: no parameter says there what type it arrives as.
#include "rewrite/collect/collector.h"
#include "rewrite/model/conditions.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

class NumberReads : public Walk {
public:
  bool VisitVAArgExpr(VAArgExpr *read) override {
    found = found || Reals::is_double(read->getType());
    return true;
  }
  bool found = false;
};

} // namespace

void Collector::variadic_definition(FunctionDecl const *function) {
  NumberReads reads;
  reads.TraverseStmt(function->getBody());
  if (reads.found) facts_.number_readers.insert(function->getQualifiedNameAsString());
}

// An integer for which the symbolic program has a class: a comparison, isnan, what truth values and rounding make. In
// doubt it may: the macro passes plain integers.
bool Collector::may_be_truth(Expr const *argument) const {
  if (!IntegerState::is_integer(argument->getType())) return false;
  if (reals_.is_symbolic_integer(argument) || Conditions(map_, reals_).mentions_real(argument)) return true;
  Expr const *bare = argument->IgnoreParenImpCasts();
  if (auto const *negation = dyn_cast<UnaryOperator>(bare); negation && negation->getOpcode() == UO_LNot)
    return may_be_truth(negation->getSubExpr());
  if (auto const *reference = dyn_cast<DeclRefExpr>(bare)) {
    auto const *variable = dyn_cast<VarDecl>(reference->getDecl());
    return variable && variable->getType()->getContainedAutoType();
  }
  auto const *call = dyn_cast<CallExpr>(bare);
  FunctionDecl const *function = call ? call->getDirectCallee() : nullptr;
  return function && Reals::pattern(function)->getDeclaredReturnType()->getContainedAutoType();
}

// In a template the arguments of printf may turn out to be numbers.
void Collector::dependent_variadic_call(CallExpr const *call) {
  FunctionDecl const *function = call->getDirectCallee();
  if (auto const *names = dyn_cast<UnresolvedLookupExpr>(call->getCallee()->IgnoreParenImpCasts()))
    if (names->getNumDecls() == 1) function = dyn_cast<FunctionDecl>((*names->decls_begin())->getUnderlyingDecl());
  if (!function || !function->isVariadic() || reals_.in_roots(function)) return;
  for (unsigned i = function->getNumParams(); i < call->getNumArgs(); ++i)
    if (call->getArg(i)->isTypeDependent() && !isa<PackExpansionExpr>(call->getArg(i)))
      wrap_for(call->getRParenLoc(), call->getArg(i), Use::value);
}

} // namespace symreal::rewrite
