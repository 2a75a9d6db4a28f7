// Literals by which a type is deduced: each becomes a REAL.
#include "rewrite/collect/handlers.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

Expr const *written(Expr const *expression) {
  while (true) {
    Expr const *inner = expression->IgnoreImplicit();
    if (auto const *bound = dyn_cast<CXXBindTemporaryExpr>(inner)) inner = bound->getSubExpr();
    if (inner == expression) return inner;
    expression = inner;
  }
}

class DeducingLiterals : public SyntaxHandler {
public:
  explicit DeducingLiterals(SyntaxTable &table) : SyntaxHandler(table) {
    on<ConditionalOperator>(NUMBERS, &DeducingLiterals::choice);
    on<VarDecl>(NUMBERS, &DeducingLiterals::deduced_variable);
    on<FunctionDecl>(NUMBERS, &DeducingLiterals::deduced_result);
    on<LambdaExpr>(NUMBERS, &DeducingLiterals::deduced_result);
    on<DecltypeTypeLoc>(NUMBERS, &DeducingLiterals::deduced_type);
    on<CallSite>(NUMBERS, &DeducingLiterals::lists);
  }

private:
  void choice(ConditionalOperator const *choice);
  void deduced_variable(VarDecl const *variable);
  void deduced_result(FunctionDecl const *function) {
    if (function->doesThisDeclarationHaveABody() && function->getDeclaredReturnType()->getContainedAutoType())
      deduced_return(function);
  }
  void deduced_result(LambdaExpr const *lambda) {
    if (!lambda->hasExplicitResultType()) deduced_return(lambda->getCallOperator());
  }
  void deduced_type(DecltypeTypeLoc type) { deduced_elements(type.getUnderlyingExpr()); }
  void lists(CallSite const *site);

  void deduced_return(FunctionDecl const *function);
  void deduced_elements(Expr const *initializer);
};

} // namespace

void DeducingLiterals::choice(ConditionalOperator const *choice) {
  if (choice->isTypeDependent() || !Reals::is_double(choice->getType())) return;
  // A macro's body is one text for all of its uses, and some may be on integers.
  if (!map_.sources().getSLocEntry(map_.frame(choice->getQuestionLoc())).isFile()) return;
  Expr const *yes = choice->getTrueExpr(), *no = choice->getFalseExpr();
  // An integer of a class and a double convert to each other.
  auto const stays = [this](Expr const *arm) {
    return reals_.stays_double(arm) &&
           !(arm->IgnoreParenImpCasts()->getType()->isIntegerType() && reals_.may_be_symbolic(arm));
  };
  bool const yes_stays = stays(yes), no_stays = stays(no);
  if (yes_stays == no_stays) return;
  Expr const *literal = (yes_stays ? yes : no)->IgnoreImpCasts();
  if (Reals::is_double(literal->getType())) wrap(literal, Use::literal);
}

// `auto s = 0.0`: the literal determines the type.
void DeducingLiterals::deduced_variable(VarDecl const *variable) {
  TypeSourceInfo const *written = variable->getTypeSourceInfo();
  Expr const *initializer = variable->getInit();
  if (!written || !initializer || variable->isConstexpr() || variable->isCXXForRangeDecl()) return;
  if (initializer->isTypeDependent()) return;
  TypeLoc type = written->getTypeLoc();
  for (TypeLoc inner = type; !inner.isNull(); inner = inner.getNextTypeLoc()) type = inner;
  if (auto const list = dyn_cast<CXXStdInitializerListExpr>(initializer->IgnoreImplicit()))
    if (type.getAs<AutoTypeLoc>()) deduced_elements(list->getSubExpr());
  if (type.getAs<DeducedTemplateSpecializationTypeLoc>()) deduced_elements(initializer);
  if (!type.getAs<AutoTypeLoc>() || !Reals::is_double(variable->getType())) return;
  Expr const *value = initializer->IgnoreImplicit();
  if (auto const *list = dyn_cast<InitListExpr>(value); list && list->getNumInits() == 1) value = list->getInit(0);
  if (is_plain_double(value)) wrap(value->IgnoreImpCasts(), Use::literal);
}

void DeducingLiterals::deduced_return(FunctionDecl const *function) {
  for (ReturnStmt const *statement : returns_of(function))
    if (Expr const *value = statement->getRetValue(); value && is_plain_double(value))
      wrap(value->IgnoreImpCasts(), Use::literal);
}

void DeducingLiterals::lists(CallSite const *site) {
  if (!takes_as_declared(site->function, reals_)) return;
  for (Expr const *argument : site->arguments)
    if (auto const *list = dyn_cast<CXXStdInitializerListExpr>(written(argument));
        list && !argument->isTypeDependent()) {
      auto const *elements = dyn_cast<InitListExpr>(list->getSubExpr()->IgnoreImplicit());
      bool const deduced = site->function->getPrimaryTemplate() != nullptr;
      if (elements && (deduced || elements->getNumInits() <= 2)) deduced_elements(elements);
    }
}

void DeducingLiterals::deduced_elements(Expr const *initializer) {
  if (!initializer) return;
  initializer = initializer->IgnoreImplicit();
  if (auto const *list = dyn_cast<InitListExpr>(initializer))
    for (Expr const *element : list->inits()) deduced_elements(element);
  else if (auto const *std_list = dyn_cast<CXXStdInitializerListExpr>(initializer))
    deduced_elements(std_list->getSubExpr());
  else if (auto const *construction = dyn_cast<CXXConstructExpr>(initializer)) {
    for (Expr const *argument : construction->arguments())
      if (!isa<CXXDefaultArgExpr>(argument)) deduced_elements(argument);
  } else if (auto const *parens = dyn_cast<ParenListExpr>(initializer))
    for (Stmt const *child : parens->children()) deduced_elements(cast<Expr>(child));
  else if (is_plain_double(initializer))
    wrap(initializer, Use::literal);
}

void add_literals(SyntaxTable &table) { table.add<DeducingLiterals>(); }

} // namespace symreal::rewrite
