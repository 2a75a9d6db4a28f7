// Arguments passed through `...`, whose type there no parameter declares.
#include "rewrite/collect/collector.h"
#include "rewrite/model/conditions.h"
#include "rewrite/model/text_functions.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// Whether the type is std::va_list, or a pointer or reference to one.
bool is_list(QualType type) {
  type = type.getCanonicalType();
  while (true) {
    if (type->isReferenceType() || type->isPointerType())
      type = type->getPointeeType();
    else if (auto const *array = type->getAsArrayTypeUnsafe())
      type = array->getElementType();
    else
      break;
  }
  auto const *record = type->getAsRecordDecl();
  return record && record->getDeclName().isIdentifier() &&
         (record->getName() == "__va_list_tag" || record->getName() == "__va_list");
}

// The destinations of a function's argument lists.
class Lists : public Walk {
public:
  Lists(SourceMap const &map, Reals const &reals, ListFact &fact) : map_(map), reals_(reals), fact_(fact) {}

  bool VisitVAArgExpr(VAArgExpr *read) override {
    fact_.reads = fact_.reads || read->getType()->isDependentType() || reals_.carries_real(read->getType());
    known_.insert(named(read->getSubExpr()));
    return true;
  }
  bool VisitCallExpr(CallExpr *call) override {
    FunctionDecl const *function = call->getDirectCallee();
    for (unsigned i = 0; i < call->getNumArgs(); ++i)
      if (Expr const *list = named(call->getArg(i)); list && function && hands(call, function, list))
        known_.insert(list);
    return true;
  }
  bool VisitDeclRefExpr(DeclRefExpr *name) override { return meet(name); }
  bool VisitMemberExpr(MemberExpr *member) override { return meet(member); }

  void finish() {
    if (llvm::all_of(met_, [&](Expr const *list) { return known_.contains(list); })) return;
    fact_.reads = true;
    fact_.handed.insert(""); // to any
  }

private:
  bool meet(Expr const *list) {
    if (is_list(list->getType())) met_.push_back(list);
    return true;
  }
  static Expr const *named(Expr const *list) {
    list = list->IgnoreParenCasts();
    while (auto const *through = dyn_cast<UnaryOperator>(list)) {
      if (through->getOpcode() != UO_AddrOf && through->getOpcode() != UO_Deref) break;
      list = through->getSubExpr()->IgnoreParenCasts();
    }
    return is_list(list->getType()) && isa<DeclRefExpr, MemberExpr>(list) ? list : nullptr;
  }

  // Whether the source shows which function takes the list; notes that function.
  bool hands(CallExpr const *call, FunctionDecl const *function, Expr const *list) {
    llvm::StringRef const name = function->getIdentifier() ? function->getName() : "";
    if (name.contains("va_end")) return true;
    if (name.contains("va_start") || name.contains("va_copy")) { // to a local list
      auto const *variable = dyn_cast<DeclRefExpr>(list);
      auto const *local = variable ? dyn_cast<VarDecl>(variable->getDecl()) : nullptr;
      return local && local->hasLocalStorage() && !local->getType()->isReferenceType();
    }
    auto const *method = dyn_cast<CXXMethodDecl>(function);
    if (Reals::pattern(function) != function || (method && (method->isVirtual() || method->getParent()->isLambda())))
      return false;
    if (reals_.in_roots(function))
      fact_.handed.insert(function->getQualifiedNameAsString());
    else if (TextUse const use = text_use(function); use == TextUse::memory || use == TextUse::outside)
      fact_.prints = true;
    else if (use != TextUse::reader) {
      bool const leaves = function->hasAttr<FormatAttr>() || function->getReturnType()->isVoidType();
      Place const place = map_.place(call->getBeginLoc());
      fact_.outside[to_string(place)] = {place, function->getQualifiedNameAsString(), leaves};
    }
    return true;
  }

  SourceMap const &map_;
  Reals const &reals_;
  ListFact &fact_;
  llvm::SmallPtrSet<Expr const *, 8> known_; // names of lists whose use is understood
  std::vector<Expr const *> met_;
};

} // namespace

void Collector::argument_list(FunctionDecl const *function) {
  bool const takes_list = llvm::any_of(
      function->parameters(), [](ParmVarDecl const *parameter) { return is_list(parameter->getOriginalType()); });
  if (!function->isVariadic() && !takes_list) return;
  if (auto const *method = dyn_cast<CXXMethodDecl>(function))
    for (CXXMethodDecl const *overridden : method->overridden_methods())
      facts_.lists[overridden->getQualifiedNameAsString()].handed.insert(method->getQualifiedNameAsString());
  Lists lists(map_, reals_, facts_.lists[function->getQualifiedNameAsString()]);
  lists.TraverseStmt(function->getBody());
  lists.finish();
}

// Whether the integer may be of a class in the symbolic program: a comparison, isnan, results of truth values and
// rounding. True in doubt: the macro passes plain integers on.
bool Collector::may_be_truth(Expr const *argument) const {
  if (!ScalarState::is_integer(argument->getType())) return false;
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

// The arguments of printf in a template may turn out to be numbers.
void Collector::dependent_variadic_call(CallExpr const *call) {
  FunctionDecl const *function = call->getDirectCallee();
  if (auto const *names = dyn_cast<UnresolvedLookupExpr>(call->getCallee()->IgnoreParenImpCasts()))
    if (names->getNumDecls() == 1) function = dyn_cast<FunctionDecl>((*names->decls_begin())->getUnderlyingDecl());
  if (!function || !function->isVariadic()) return;
  std::string const reader = reals_.in_roots(function) ? function->getQualifiedNameAsString() : "";
  for (unsigned i = function->getNumParams(); i < call->getNumArgs(); ++i)
    if (call->getArg(i)->isTypeDependent() && !isa<PackExpansionExpr>(call->getArg(i)))
      wrap_for(call->getRParenLoc(), call->getArg(i), Use::value, reader);
}

} // namespace symreal::rewrite
