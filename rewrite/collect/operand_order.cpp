#include "rewrite/collect/walks.h"

#include "rewrite/model/context_walk.h"
#include "rewrite/model/effects.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

// Signs, choices and operations with 0, 1 and -1, which gcc moves, joins and drops; it may then begin with either
// operand.
class Movable : public Walk {
public:
  static bool is_within(Expr const *expression, ASTContext const &context) {
    return !Movable(context).TraverseStmt(const_cast<Expr *>(expression)); // ends at the first
  }
  bool TraverseCallExpr(CallExpr *) override { return true; } // arguments stay in place
  bool VisitUnaryOperator(UnaryOperator *unary) override { return unary->getOpcode() != UO_Minus; }
  bool VisitAbstractConditionalOperator(AbstractConditionalOperator *) override { return false; }
  bool VisitBinaryOperator(BinaryOperator *binary) override {
    return !is_unit(binary->getLHS()) && !is_unit(binary->getRHS());
  }

private:
  explicit Movable(ASTContext const &context) : context_(context) {}

  bool is_unit(Expr const *operand) const {
    llvm::APFloat value(0.0);
    return !operand->isValueDependent() && Reals::is_double(operand->getType()) &&
           operand->EvaluateAsFloat(value, context_) && (value.isZero() || llvm::abs(value).isExactlyValue(1.0));
  }

  ASTContext const &context_;
};

bool is_variable(Expr const *expression) {
  auto const *read = dyn_cast<ImplicitCastExpr>(expression->IgnoreParens());
  if (!read || read->getCastKind() != CK_LValueToRValue) return false;
  Expr const *object = read->getSubExpr()->IgnoreParens();
  ValueDecl const *declaration = nullptr;
  if (auto const *name = dyn_cast<DeclRefExpr>(object)) declaration = name->getDecl();
  if (auto const *member = dyn_cast<MemberExpr>(object)) declaration = member->getMemberDecl();
  return isa_and_nonnull<VarDecl>(declaration) && !declaration->getType()->isReferenceType();
}

// Whether gcc evaluates the right operand first: it does if the operands commute and the left one is a variable.
bool gcc_begins_on_the_right(BinaryOperator const *binary) {
  bool const commutes = binary->getOpcode() == BO_Add || binary->getOpcode() == BO_Mul || binary->isComparisonOp();
  return commutes && is_variable(binary->getLHS());
}

class OperandOrder : public ContextWalk {
public:
  OperandOrder(ASTContext const &context, SourceMap const &map, Reals const &reals, Facts &facts)
      : ContextWalk(map, reals),
        context_(context),
        effects_(reals),
        facts_(facts) {}

  bool shouldVisitTemplateInstantiations() const override { return true; }
  bool shouldVisitImplicitCode() const override { return false; }
  bool TraverseDecltypeTypeLoc(DecltypeTypeLoc) override { return true; } // unevaluated
  bool TraverseLambdaExpr(LambdaExpr *lambda) override {
    if (FunctionTemplateDecl *generic = lambda->getLambdaClass()->getDependentLambdaCallOperator())
      for (FunctionDecl *one : generic->specializations())
        if (one->hasBody()) {
          FunctionDecl const *const outer = std::exchange(function_, one);
          bool const more = TraverseStmt(one->getBody());
          function_ = outer;
          if (!more) return false;
        }
    return ContextWalk::TraverseLambdaExpr(lambda);
  }

  bool VisitBinaryOperator(BinaryOperator *binary) override {
    Expr const *left = binary->getLHS(), *right = binary->getRHS();
    if (passive_ || no_state_ || binary->isInstantiationDependent()) return true;
    if (!binary->isAdditiveOp() && !binary->isMultiplicativeOp() && !binary->isRelationalOp() &&
        !binary->isEqualityOp())
      return true;
    if (!Reals::is_double(left->getType()) || (!reals_.is_real(left) && !reals_.is_real(right))) return true;
    if (!map_.in_roots(binary->getOperatorLoc()) || !conflict(left, right)) return true;
    std::optional<Span> const span = map_.range(right->getSourceRange());
    if (span) on_numbers_.emplace(*span, binary->getOperatorLoc());
    if (is_told(right)) return true;
    bool const may_move = Movable::is_within(left, context_) || Movable::is_within(right, context_);
    bool const is_known = !may_move || !named_.of(left).meet(named_.of(right));
    if (is_known && gcc_begins_on_the_right(binary)) return true; // as with the operator of a class
    // Operands in a macro's argument may be of any types, as in a template.
    if (span && names_function(right))
      return refuse(binary->getOperatorLoc(), "one operand is evaluated late, and asks for the name of its function"),
             true;
    if (!is_known || !function_ || !span || !map_.is_in_one_place(binary->getSourceRange()))
      refuse(binary->getOperatorLoc());
    else
      facts_.wraps.insert({*span, Use::later, ""});
    return true;
  }
  bool VisitCallExpr(CallExpr *call) override {
    if (passive_ || no_state_ || call->isInstantiationDependent() || !map_.in_roots(call->getBeginLoc())) return true;
    FunctionDecl const *function = call->getDirectCallee();
    std::vector<Expr const *> all(call->arg_begin(), call->arg_end());
    bool const has_object = isa<CXXOperatorCallExpr>(call) && isa_and_nonnull<CXXMethodDecl>(function) && !all.empty();
    if (auto const *operation = dyn_cast<CXXOperatorCallExpr>(call);
        operation && operation->isInfixBinaryOp() && Reals::is_double(call->getArg(1)->getType()))
      if (std::optional<Span> const span = map_.range(call->getArg(1)->getSourceRange())) on_classes_.insert(*span);
    for (std::size_t i = has_object ? 1 : 0; i < all.size(); ++i) argument(all, i);
    return true;
  }
  bool VisitCXXConstructExpr(CXXConstructExpr *construction) override {
    if (passive_ || no_state_ || construction->isInstantiationDependent() || construction->getNumArgs() < 2 ||
        !map_.in_roots(construction->getBeginLoc()))
      return true;
    std::vector<Expr const *> const all(construction->arg_begin(), construction->arg_end());
    for (std::size_t i = 0; i < all.size(); ++i) argument(all, i);
    return true;
  }

  // One text for both: an operator of the language, in another instantiation one of a class with a number.
  void refuse_mixed() {
    for (auto const &[span, place] : on_numbers_)
      if (on_classes_.contains(span) && facts_.wraps.contains({span, Use::later, ""})) refuse(place);
  }

private:
  // Whether an earlier rewriting has handled the operand.
  bool is_told(Expr const *operand) const {
    SourceLocation const begin = operand->getBeginLoc();
    return map_.is_argument_of(begin, "REAL_LATER") || map_.is_argument_of(begin, "REAL_NOW");
  }

  bool conflict(Expr const *left, Expr const *right) {
    Effects const one = effects_.of(left, function_), other = effects_.of(right, function_);
    return (one.changes && (other.changes || other.reads || other.talks)) ||
           (other.changes && (one.reads || one.talks)) || (one.talks && other.talks);
  }

  // A number that is read for a parameter, while another argument changes it.
  void argument(std::vector<Expr const *> const &all, std::size_t index) {
    auto const *read = dyn_cast<ImplicitCastExpr>(all[index]);
    if (!read || read->getCastKind() != CK_LValueToRValue || !reals_.is_real(read)) return;
    if (!effects_.of(read, function_).reads) return;
    bool is_changed = false;
    for (std::size_t i = 0; i < all.size(); ++i)
      is_changed |= i != index && !isa<CXXDefaultArgExpr>(all[i]) && effects_.of(all[i], function_).changes;
    if (!is_changed || is_told(read)) return;
    if (std::optional<Span> const span = map_.range(read->getSourceRange()))
      facts_.wraps.insert({*span, Use::now, ""});
    else
      refuse(read->getBeginLoc());
  }

  // An operand that is evaluated late stands in a function of its own.
  static bool names_function(Stmt const *part) {
    if (auto const *argument = dyn_cast<CXXDefaultArgExpr>(part)) return names_function(argument->getExpr());
    if (isa<PredefinedExpr, SourceLocExpr>(part)) return true;
    return llvm::any_of(part->children(), [](Stmt const *one) { return one && names_function(one); });
  }

  void refuse(SourceLocation location,
              char const *why = "one operand changes what the other reads, or both change the same object") {
    add_diagnostic(facts_, {DiagnosticId::evaluation_order, map_.place(location), why, map_.expansions(location)});
  }
  ASTContext const &context_;
  EffectAnalysis effects_;
  NamedVariableAnalysis named_;
  Facts &facts_;
  // Right operands of operators.
  std::map<Span, SourceLocation> on_numbers_;
  std::set<Span> on_classes_;
};

} // namespace

void collect_operand_order(ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts) {
  OperandOrder order(context, map, reals, facts);
  order.TraverseDecl(context.getTranslationUnitDecl());
  order.refuse_mixed();
}

} // namespace symreal::rewrite
