// Truth values and integers whose type is looked at: a comparison of REALs is a class of its own, and so is an integer
// that stays symbolic.
#include "rewrite/collect/handlers.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

class Truths : public SyntaxHandler {
public:
  explicit Truths(SyntaxTable &table) : SyntaxHandler(table) {
    on<CallSite>(NUMBERS, &Truths::arguments);
    on<CallSite>(INSTANCES, &Truths::instantiated_arguments);
    on<CXXThrowExpr>(NUMBERS, &Truths::thrown);
    on<UnaryExprOrTypeTraitExpr>(ANYWHERE, &Truths::operand);
    on<CXXTypeidExpr>(ANYWHERE, &Truths::operand);
    on<DecltypeTypeLoc>(ANYWHERE, &Truths::operand);
    on<concepts::ExprRequirement>(ANYWHERE, &Truths::operand);
  }

private:
  void instantiated_arguments(CallSite const *site) {
    for (unsigned i = 0; i < site->arguments.size(); ++i) {
      truth_argument(site->function, i, site->arguments[i], true);
      counted_argument(site->function, i, site->arguments[i], site->is_overloaded);
    }
  }
  void thrown(CXXThrowExpr const *expression) {
    if (expression->getSubExpr()) erased(expression->getSubExpr());
  }
  // The operand of sizeof or decltype, or an operand that a concept examines.
  void operand(UnaryExprOrTypeTraitExpr const *expression) {
    if (!expression->isArgumentType()) looked_at(expression->getArgumentExpr()->IgnoreParens());
  }
  void operand(CXXTypeidExpr const *expression) {
    if (!expression->isTypeOperand()) looked_at(expression->getExprOperand());
  }
  void operand(DecltypeTypeLoc type) { looked_at(type.getUnderlyingExpr()); }
  void operand(concepts::ExprRequirement const *requirement) {
    if (requirement->isCompound() && !requirement->isExprSubstitutionFailure()) looked_at(requirement->getExpr());
  }

  void arguments(CallSite const *site) {
    if (reals_.external(site->function)) return;
    kept_by_type(site);
    if (!takes_as_declared(site->function, reals_)) return;
    for (unsigned i = 0; i < site->arguments.size(); ++i)
      if (Expr const *argument = site->arguments[i]; !argument->isTypeDependent()) {
        truth_argument(site->function, i, argument, site->is_overloaded);
        counted_argument(site->function, i, argument, site->is_overloaded);
        extreme_argument(site->function, i, argument);
      }
  }

  // A comparison of REALs as an argument by whose type a function is chosen or made: of a comparison that is bool.
  void truth_argument(FunctionDecl const *function, unsigned index, Expr const *argument, bool overloaded) {
    if (index >= function->getNumParams() || !reals_.in_roots(function)) return;
    if (!argument->IgnoreParenImpCasts()->getType()->isBooleanType() || !may_be_truth(argument)) return;
    FunctionTemplateDecl const *primary = function->getPrimaryTemplate();
    QualType const parameter = function->getParamDecl(index)->getType();
    bool const is_deduced = primary && index < primary->getTemplatedDecl()->getNumParams() &&
                            primary->getTemplatedDecl()->getParamDecl(index)->getType()->isDependentType() &&
                            parameter.getNonReferenceType()->isBooleanType();
    if (!is_deduced && !(overloaded && !Reals::is_double(parameter))) return;
    wrap(argument->IgnoreImpCasts(), Use::argument, "bool");
  }

  // f(1 + (x > 1)) of several functions: the class of the sum converts to the parameters of all of them.
  void counted_argument(FunctionDecl const *function, unsigned index, Expr const *argument, bool overloaded) {
    if (!overloaded || index >= function->getNumParams() || !reals_.in_roots(function)) return;
    if (!Reals::is_integer(argument->IgnoreParenImpCasts()->getType())) return;
    if (!reals_.may_be_symbolic(argument) || reals_.is_symbolic_integer(argument)) return;
    FunctionTemplateDecl const *primary = function->getPrimaryTemplate();
    bool const is_pattern = primary && index < primary->getTemplatedDecl()->getNumParams();
    if (is_pattern && primary->getTemplatedDecl()->getParamDecl(index)->getType()->isDependentType()) return;
    if (Reals::is_double(function->getParamDecl(index)->getType())) return;
    Expr const *written = Reals::spelled_integer(argument)->IgnoreParenImpCasts();
    if (instance_) // in another it may be a number
      wrap(written, Use::erased);
    else
      wrap(written, Use::conversion, spelled(written->getType()));
  }

  // std::max<long>(i, x > 1): of the overloads for symbolic integers none is better than the others.
  void extreme_argument(FunctionDecl const *function, unsigned index, Expr const *argument) {
    if (index >= function->getNumParams() || !function->isInStdNamespace() || !function->getPrimaryTemplate()) return;
    if (!function->getIdentifier() || (function->getName() != "min" && function->getName() != "max")) return;
    QualType const parameter = function->getParamDecl(index)->getType().getNonReferenceType();
    Expr const *written = argument->IgnoreParenImpCasts();
    if (auto const *temporary = dyn_cast<MaterializeTemporaryExpr>(argument)) written = temporary->getSubExpr();
    written = written->IgnoreParenImpCasts();
    if (parameter->isIntegerType() && !context_.hasSameUnqualifiedType(parameter, written->getType()) &&
        may_be_truth(written))
      wrap(written, Use::conversion, spelled(parameter));
  }

  // Thrown, or kept in a std::any: who takes it out names its type.
  void erased(Expr const *operand) {
    Expr const *bare = operand->IgnoreParenImpCasts();
    if (auto const *temporary = dyn_cast<MaterializeTemporaryExpr>(operand))
      bare = temporary->getSubExpr()->IgnoreParenImpCasts();
    if (!map_.in_roots(bare->getBeginLoc())) return;
    bool const may_be_plain = bare->isTypeDependent() && !isa<CXXUnresolvedConstructExpr>(bare);
    // A handler for double takes REALs.
    if (Reals::is_double(bare->getType()) && reals_.stays_double(bare)) return wrap(bare, Use::literal);
    if (may_be_plain || (bare->getType()->isIntegralOrEnumerationType() && !bare->isEvaluatable(context_)))
      wrap(bare, Use::erased);
  }

  void kept_by_type(CallSite const *site) {
    auto const &[expression, place, function, arguments, overloaded] = *site;
    if (arguments.size() != 1 || !function->getPrimaryTemplate()) return;
    auto const *method = dyn_cast<CXXMethodDecl>(function);
    auto const *named = method ? static_cast<NamedDecl const *>(method->getParent()) : function;
    bool const is_known = named->getIdentifier() && named->getName() == (method ? "any" : "make_exception_ptr");
    if (is_known && named->isInStdNamespace()) erased(arguments.front());
  }

  // sizeof(x > 1), decltype(x > 1): a comparison of REALs is a class of its own, and in a template it may be one.
  void looked_at(Expr const *operand) {
    Expr const *bare = operand->IgnoreParens();
    if (!map_.in_roots(operand->getBeginLoc())) return;
    if (bare->isTypeDependent()) {
      auto const *binary = dyn_cast<BinaryOperator>(bare);
      auto const *unary = dyn_cast<UnaryOperator>(bare);
      auto const *overloaded = dyn_cast<CXXOperatorCallExpr>(bare);
      bool const is_truth = (binary && (binary->isComparisonOp() || binary->isLogicalOp())) ||
                            (unary && unary->getOpcode() == UO_LNot) ||
                            (overloaded && (overloaded->isComparisonOp() || overloaded->getOperator() == OO_Exclaim));
      auto const *name = dyn_cast<DeclRefExpr>(bare);
      bool const is_variable =
          name && isa<VarDecl>(name->getDecl()) && name->getDecl()->getType()->getContainedAutoType();
      if (is_truth || is_variable || isa<CallExpr>(bare)) wrap(operand, Use::truth);
    } else if (bare->getType()->isBooleanType() && may_be_truth(bare))
      wrap(operand, Use::truth);
  }
};

} // namespace

void add_truths(SyntaxTable &table) { table.add<Truths>(); }

} // namespace symreal::rewrite
