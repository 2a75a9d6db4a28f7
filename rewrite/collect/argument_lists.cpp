// Lists of variable arguments: where a function of the program hands its list on to.
#include "rewrite/collect/handlers.h"
#include "rewrite/model/library.h"
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

class ArgumentLists : public SyntaxHandler {
public:
  explicit ArgumentLists(SyntaxTable &table) : SyntaxHandler(table) {
    on<LambdaExpr>(ANYWHERE, &ArgumentLists::of);
    on<FunctionDecl>(ANYWHERE, &ArgumentLists::of);
  }

private:
  void of(LambdaExpr const *lambda) { argument_list(lambda->getCallOperator()); }
  void of(FunctionDecl const *function) {
    if (function->doesThisDeclarationHaveABody()) argument_list(function);
  }

  void argument_list(FunctionDecl const *function);
};

} // namespace

void ArgumentLists::argument_list(FunctionDecl const *function) {
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

void add_argument_lists(SyntaxTable &table) { table.add<ArgumentLists>(); }

} // namespace symreal::rewrite
