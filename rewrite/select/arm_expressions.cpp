#include "rewrite/model/library.h"
#include "rewrite/select/arm_walker.h"

namespace symreal::rewrite {
using namespace clang;

void ArmWalker::expression(Expr const *expression) {
  if (!expression || blocked()) return;
  if (expression->getType().isVolatileQualified()) return block(expression->getExprLoc(), {ReasonId::volatile_object});
  switch (expression->getStmtClass()) {
  case Stmt::CallExprClass:
  case Stmt::CXXMemberCallExprClass:
  case Stmt::CXXOperatorCallExprClass:
  case Stmt::UserDefinedLiteralClass: return call(cast<CallExpr>(expression));
  case Stmt::CXXConstructExprClass:
  case Stmt::CXXTemporaryObjectExprClass: return construction(cast<CXXConstructExpr>(expression));
  case Stmt::BinaryOperatorClass:
  case Stmt::CompoundAssignOperatorClass: return binary(cast<BinaryOperator>(expression));
  case Stmt::UnaryOperatorClass: {
    auto const *unary = cast<UnaryOperator>(expression);
    if (unary->isIncrementDecrementOp()) return assignment(unary->getSubExpr());
    return this->expression(unary->getSubExpr());
  }
  case Stmt::CXXDefaultArgExprClass: return this->expression(cast<CXXDefaultArgExpr>(expression)->getExpr());
  case Stmt::CXXDefaultInitExprClass: return this->expression(cast<CXXDefaultInitExpr>(expression)->getExpr());
  case Stmt::CXXThrowExprClass: return block(expression->getExprLoc(), {ReasonId::throws});
  case Stmt::CXXNewExprClass: return block(expression->getExprLoc(), {ReasonId::makes_new});
  case Stmt::CXXDeleteExprClass: return block(expression->getExprLoc(), {ReasonId::deletes});
  case Stmt::LambdaExprClass: return block(expression->getExprLoc(), {ReasonId::lambda});
  case Stmt::StmtExprClass: return block(expression->getExprLoc(), {ReasonId::statement_expression});
  case Stmt::VAArgExprClass: return block(expression->getExprLoc(), {ReasonId::variable_arguments});
  case Stmt::UnaryExprOrTypeTraitExprClass:
  case Stmt::CXXNoexceptExprClass: return; // not evaluated
  case Stmt::CXXBindTemporaryExprClass: return block(expression->getExprLoc(), {ReasonId::destructor});
  // Expressions that only compute from their operands.
  case Stmt::ParenExprClass:
  case Stmt::ImplicitCastExprClass:
  case Stmt::CStyleCastExprClass:
  case Stmt::CXXStaticCastExprClass:
  case Stmt::CXXConstCastExprClass:
  case Stmt::CXXFunctionalCastExprClass:
  case Stmt::ConditionalOperatorClass:
  case Stmt::BinaryConditionalOperatorClass:
  case Stmt::OpaqueValueExprClass:
  case Stmt::MemberExprClass:
  case Stmt::ArraySubscriptExprClass:
  case Stmt::InitListExprClass:
  case Stmt::ConstantExprClass:
  case Stmt::ExprWithCleanupsClass:
  case Stmt::MaterializeTemporaryExprClass:
  case Stmt::CXXStdInitializerListExprClass:
  case Stmt::CXXRewrittenBinaryOperatorClass:
  case Stmt::SubstNonTypeTemplateParmExprClass:
  case Stmt::CompoundLiteralExprClass:
  case Stmt::DeclRefExprClass:
  case Stmt::CXXThisExprClass:
  case Stmt::FloatingLiteralClass:
  case Stmt::IntegerLiteralClass:
  case Stmt::CharacterLiteralClass:
  case Stmt::StringLiteralClass:
  case Stmt::PredefinedExprClass:
  case Stmt::CXXBoolLiteralExprClass:
  case Stmt::CXXNullPtrLiteralExprClass:
  case Stmt::GNUNullExprClass:
  case Stmt::ImplicitValueInitExprClass:
  case Stmt::CXXScalarValueInitExprClass:
  case Stmt::TypeTraitExprClass:
    for (Stmt const *part : expression->children())
      if (auto const *inner = dyn_cast_or_null<Expr>(part)) this->expression(inner);
    return;
  default: return block(expression->getExprLoc(), {ReasonId::expression_kind, expression->getStmtClassName()});
  }
}

void ArmWalker::binary(BinaryOperator const *binary) {
  expression(binary->getRHS());
  if (binary->isAssignmentOp())
    assignment(binary->getLHS());
  else
    expression(binary->getLHS());
}

// modf(x, &whole) and its like write through their pointers.
void ArmWalker::math_call(CallExpr const *call) {
  for (Expr const *argument : call->arguments()) {
    Expr const *written = argument->IgnoreParenImpCasts();
    auto const *address = dyn_cast<UnaryOperator>(written);
    if (!written->getType()->isPointerType())
      expression(argument);
    else if (address && address->getOpcode() == UO_AddrOf)
      assignment(address->getSubExpr());
    else
      block(argument->getExprLoc(), {ReasonId::written_through_pointer});
  }
}

namespace {

bool in_eigen(Decl const *declaration) {
  for (DeclContext const *scope = declaration->getDeclContext(); scope; scope = scope->getParent())
    if (auto const *space = dyn_cast<NamespaceDecl>(scope); space && space->getName() == "Eigen") return true;
  return false;
}

// Fixed arrays of numbers of known libraries: their operators compute only.
bool is_number_array(CXXRecordDecl const *record) {
  if (in_eigen(record)) return true;
  return record->isInStdNamespace() && (record->getName() == "array" || record->getName() == "complex");
}

} // namespace

bool ArmWalker::library_call(CallExpr const *call, FunctionDecl const *function) {
  if (is_std_function(function, {"min", "max", "abs", "clamp", "move", "forward", "get", "size", "begin", "end", "real",
                                 "imag", "norm", "conj", "data"})) {
    for (Expr const *argument : call->arguments()) expression(argument);
    return true;
  }
  auto const *method = dyn_cast<CXXMethodDecl>(function);
  bool const numbers = method ? is_number_array(method->getParent()) : in_eigen(function);
  if (!numbers && !(method && method->getParent()->isInStdNamespace())) return false;
  OverloadedOperatorKind const op = function->getOverloadedOperator();
  bool const assigns = numbers && (op == OO_Equal || op == OO_PlusEqual || op == OO_MinusEqual || op == OO_StarEqual ||
                                   op == OO_SlashEqual);
  bool const looks = op == OO_Subscript || (op == OO_Call && numbers) ||
                     (function->getDeclName().isIdentifier() && library::has(function->getName(), library::VIEWS)) ||
                     (numbers && (!method || method->isConst() || method->isStatic()));
  if (!assigns && !looks) return false;
  if (auto const *member = dyn_cast<CXXMemberCallExpr>(call)) expression(member->getImplicitObjectArgument());
  for (unsigned i = 0; i < call->getNumArgs(); ++i)
    if (i > 0 || !assigns) expression(call->getArg(i));
  if (assigns) assignment(call->getArg(0));
  return true;
}

void ArmWalker::call(CallExpr const *call) {
  FunctionDecl const *function = call->getDirectCallee();
  if (!function) return block(call->getExprLoc(), {ReasonId::call_by_pointer});
  if (analysis_.reals_.is_math(function)) return math_call(call);
  if (library_call(call, function)) return;
  // The assignment that the compiler wrote: member by member.
  auto const *method = dyn_cast<CXXMethodDecl>(function);
  if (method && method->isTrivial() && (method->isCopyAssignmentOperator() || method->isMoveAssignmentOperator())) {
    expression(call->getArg(1));
    return assignment(call->getArg(0));
  }
  if (auto const *member = dyn_cast<CXXMemberCallExpr>(call)) expression(member->getImplicitObjectArgument());
  for (Expr const *argument : call->arguments()) expression(argument);
  if (blocked()) return;
  if (std::optional<Reason> const why = analysis_.call_of(function)) block(call->getExprLoc(), *why);
}

void ArmWalker::construction(CXXConstructExpr const *construction) {
  for (Expr const *argument : construction->arguments()) expression(argument);
  CXXConstructorDecl const *constructor = construction->getConstructor();
  if (blocked() || constructor->isTrivial() || constructor->isDefaulted() || is_number_array(constructor->getParent()))
    return;
  if (std::optional<Reason> const why = analysis_.call_of(constructor)) block(construction->getExprLoc(), *why);
}

} // namespace symreal::rewrite
