#include "rewrite/model/reals.h"

#include "engine/ops/operation.h"
#include "rewrite/model/library.h"
#include "rewrite/source/walk.h"

#include <algorithm>

namespace symreal::rewrite {
using namespace clang;

bool Reals::is_double(QualType type) {
  if (type.isNull()) return false;
  auto const *builtin = type.getNonReferenceType().getCanonicalType()->getAs<BuiltinType>();
  return builtin && builtin->getKind() == BuiltinType::Double;
}

bool Reals::holds(QualType type, Depth depth, llvm::SmallPtrSetImpl<Type const *> &seen) const {
  if (type.isNull()) return false;
  type = type.getCanonicalType().getUnqualifiedType();
  if (is_double(type) && !type->isReferenceType()) return true;
  if (!seen.insert(type.getTypePtr()).second) return false;
  if (auto const *array = type->getAsArrayTypeUnsafe()) return holds(array->getElementType(), depth, seen);
  if (depth == Depth::anything) {
    if (QualType const pointee = type->getPointeeType(); !pointee.isNull()) return holds(pointee, depth, seen);
    if (auto const *function = type->getAs<FunctionProtoType>()) {
      if (holds(function->getReturnType(), depth, seen)) return true;
      for (QualType parameter : function->getParamTypes())
        if (holds(parameter, depth, seen)) return true;
    }
  }
  auto const *record = type->getAsRecordDecl();
  if (!record) return false;
  if (auto const *special = dyn_cast<ClassTemplateSpecializationDecl>(record)) {
    if (is_passive_template(special)) return false;
    for (TemplateArgument const &argument : special->getTemplateArgs().asArray())
      if (argument.getKind() == TemplateArgument::Type && holds(argument.getAsType(), depth, seen)) return true;
  }
  if (!in_roots(record)) return false;
  record = record->getDefinition();
  if (!record) return false;
  if (auto const *derived = dyn_cast<CXXRecordDecl>(record))
    for (CXXBaseSpecifier const &base : derived->bases())
      if (holds(base.getType(), depth, seen)) return true;
  for (FieldDecl const *field : record->fields())
    if (holds(field->getType(), depth, seen)) return true;
  return false;
}

bool Reals::carries_real(QualType type) const {
  llvm::SmallPtrSet<Type const *, 16> seen;
  return holds(type, Depth::storage, seen);
}

bool Reals::mentions_real(QualType type) const {
  llvm::SmallPtrSet<Type const *, 16> seen;
  return holds(type, Depth::anything, seen);
}

QualType Reals::pointee(Expr const *expression) {
  QualType const type = expression->IgnoreParenImpCasts()->getType();
  return type->isArrayType() ? QualType(type->getAsArrayTypeUnsafe()->getElementType()) : type->getPointeeType();
}

bool Reals::is_passive(VarDecl const *variable) const {
  if (variable->isConstexpr() || !in_roots(variable)) return true;
  // An initialiser in the class of a static const double is a GNU extension for arithmetic types: it stays double.
  return variable->isStaticDataMember() && variable->getType().isConstQualified() &&
         variable->getFirstDecl()->hasInit() && !variable->isInline();
}

bool Reals::is_passive_template(NamedDecl const *declaration) {
  if (!declaration || !declaration->isInStdNamespace()) {
    // chrono is a namespace of its own within std.
    auto const *space = declaration ? dyn_cast<NamespaceDecl>(declaration->getDeclContext()) : nullptr;
    return space && space->getName() == "chrono" && space->isInStdNamespace();
  }
  llvm::StringRef const name = declaration->getName();
  return name.ends_with("_distribution") || name == "generate_canonical" || name == "is_floating_point" ||
         name == "is_arithmetic";
}

bool Reals::is_passive_class(QualType type) {
  auto const *record = type.isNull() ? nullptr : type.getNonReferenceType()->getAsCXXRecordDecl();
  return record && is_passive_template(record);
}

bool Reals::is_math_name(llvm::StringRef name) {
  // Names of the operation table's calls, in both forms, and of functions that the runtime builds from them.
  enum Numbers { REAL, PLAIN };
  static llvm::StringSet<> const names = [] {
    llvm::StringSet<> known;
    for (OperationInfo const &operation : operations())
      if (operation.form == Form::call)
        for (std::string_view call : {operation.name, operation.c}) known.insert(llvm::StringRef(call));
#define MATH_FUNCTION(name, types, numbers)                                                                            \
  if constexpr (numbers == REAL) known.insert(#name);
#include <symreal/math_functions.def>
#undef MATH_FUNCTION
    return known;
  }();
  name.consume_front("__builtin_");
  if (name.starts_with("__")) name = name.drop_front(2).take_until([](char c) { return c == '_'; }); // __isnan of glibc
  return names.contains(name) || name == "isinf_sign";
}

bool Reals::is_declared_math(FunctionDecl const *function) {
  return !function->getASTContext().getLangOpts().CPlusPlus && function->isExternC() && !function->isDefined() &&
         function->getBuiltinID() != 0 && is_math_name(function->getName());
}

bool Reals::is_math(FunctionDecl const *function) const {
  if (!function || !function->getDeclName().isIdentifier()) return false;
  if (in_roots(function)) return is_declared_math(function);
  DeclContext const *context = function->getDeclContext()->getRedeclContext();
  if (!context->isTranslationUnit() && !function->isInStdNamespace()) return false;
  if (function->getName() == "lerp") return function->isInStdNamespace();
  return is_math_name(function->getName());
}

FunctionDecl const *Reals::pattern(FunctionDecl const *function) {
  if (FunctionDecl const *from = function->getTemplateInstantiationPattern()) return from;
  if (FunctionTemplateDecl const *from = function->getPrimaryTemplate()) return from->getTemplatedDecl();
  if (FunctionDecl const *from = function->getInstantiatedFromMemberFunction()) return from;
  return function;
}

// Whether the expression is a part of an object that stays double: an element of a constexpr array, a member of an
// object whose class is not rewritten.
bool Reals::object_is_passive(Expr const *expression) const {
  expression = expression->IgnoreParenImpCasts();
  if (auto const *reference = dyn_cast<DeclRefExpr>(expression)) {
    auto const *variable = dyn_cast<VarDecl>(reference->getDecl());
    return variable && (variable->isConstexpr() || (!in_roots(variable) && !isa<ParmVarDecl>(variable)));
  }
  if (auto const *index = dyn_cast<ArraySubscriptExpr>(expression)) return object_is_passive(index->getBase());
  if (auto const *member = dyn_cast<MemberExpr>(expression)) return object_is_passive(member->getBase());
  if (auto const *call = dyn_cast<CXXOperatorCallExpr>(expression))
    return call->getOperator() == OO_Subscript && object_is_passive(call->getArg(0));
  return false;
}

// Whether a mathematical function's argument is an integer that depends on a number.
static bool is_integer_of_numbers(Reals const &reals, Expr const *argument) {
  Expr const *written = argument->IgnoreParenImpCasts();
  auto const depends = [&reals](Expr const *part) {
    return reals.integer_depends(part, [](CastExpr const *) { return true; });
  };
  if (auto const *choice = dyn_cast<ConditionalOperator>(written))
    return depends(choice->getTrueExpr()) || depends(choice->getFalseExpr());
  return depends(written);
}

bool Reals::call_stays_double(CallExpr const *call) const {
  FunctionDecl const *function = call->getDirectCallee();
  if (!function || in_roots(function) || external(function)) return false;
  if (is_math(function)) {
    for (Expr const *argument : call->arguments()) {
      QualType const type = argument->getType().getNonReferenceType();
      bool const is_complex = type->isRecordType() && carries_real(type) && !object_is_passive(argument);
      if (is_complex || !stays_double(argument) || is_integer_of_numbers(*this, argument)) return false;
    }
    return true;
  }
  if (auto const *method = dyn_cast<CXXMethodDecl>(function))
    if (is_passive_template(method->getParent())) return true;
  if (auto const *member = dyn_cast<CXXMemberCallExpr>(call))
    if (object_is_passive(member->getImplicitObjectArgument())) return true;
  if (auto const *subscript = dyn_cast<CXXOperatorCallExpr>(call))
    if (subscript->getNumArgs() > 0 && isa<CXXMethodDecl>(function) && object_is_passive(subscript->getArg(0)))
      return true;
  QualType const declared = pattern(function)->getReturnType();
  return !declared->isDependentType() && is_double(declared);
}

namespace {

// Searches for a number that becomes REAL: a choice that depends on it is a REAL, whatever its arms are.
class Numbers : public Walk {
public:
  explicit Numbers(Reals const &reals) : reals_(reals) {}
  bool are_in(Expr const *expression) { return !TraverseStmt(const_cast<Expr *>(expression)); }
  bool VisitExpr(Expr *expression) override {
    return !reals_.is_real(expression) && !reals_.is_symbolic_integer(expression);
  }

private:
  Reals const &reals_;
};

// Skips nodes without text.
Expr const *spelled(Expr const *expression) {
  while (true) {
    Expr const *inner = expression->IgnoreParenImpCasts();
    if (auto const *full = dyn_cast<FullExpr>(inner))
      inner = full->getSubExpr();
    else if (auto const *temporary = dyn_cast<MaterializeTemporaryExpr>(inner))
      inner = temporary->getSubExpr();
    else if (auto const *defaulted = dyn_cast<CXXDefaultArgExpr>(inner))
      inner = defaulted->getExpr();
    if (inner == expression) return expression;
    expression = inner;
  }
}

} // namespace

bool Reals::stays_double(Expr const *expression) const {
  expression = spelled(expression);
  if (!is_double(expression->getType())) return true;
  if (table_of(expression)) return false;
  if (isa<FloatingLiteral>(expression)) return true;
  if (auto const *unary = dyn_cast<UnaryOperator>(expression)) {
    if (unary->getOpcode() == UO_Plus || unary->getOpcode() == UO_Minus) return stays_double(unary->getSubExpr());
    return unary->getOpcode() == UO_Extension && stays_double(unary->getSubExpr());
  }
  if (auto const *binary = dyn_cast<BinaryOperator>(expression)) {
    if (binary->isAssignmentOp()) return false;
    return (binary->isCommaOp() || stays_double(binary->getLHS())) && stays_double(binary->getRHS());
  }
  if (auto const *choice = dyn_cast<ConditionalOperator>(expression))
    return stays_double(choice->getTrueExpr()) && stays_double(choice->getFalseExpr()) &&
           !Numbers(*this).are_in(choice->getCond());
  if (auto const *reference = dyn_cast<DeclRefExpr>(expression)) {
    if (isa<NonTypeTemplateParmDecl>(reference->getDecl())) return true;
    auto const *variable = dyn_cast<VarDecl>(reference->getDecl());
    return variable && !isa<ParmVarDecl>(variable) && is_passive(variable);
  }
  if (auto const *member = dyn_cast<MemberExpr>(expression)) {
    if (auto const *variable = dyn_cast<VarDecl>(member->getMemberDecl())) return is_passive(variable);
    if (object_is_passive(member)) return true;
    auto const *record = dyn_cast<RecordDecl>(member->getMemberDecl()->getDeclContext());
    return record && !in_roots(record) && !isa<ClassTemplateSpecializationDecl>(record);
  }
  if (isa<ArraySubscriptExpr>(expression)) return object_is_passive(expression);
  if (auto const *call = dyn_cast<CallExpr>(expression)) return call_stays_double(call);
  return isa<SubstNonTypeTemplateParmExpr>(expression) || isa<UserDefinedLiteral>(expression);
}

bool Reals::computes_with_counted(Expr const *expression) const {
  expression = spelled(expression);
  if (!is_double(expression->getType())) return false;
  auto const takes = [this](Expr const *operand) {
    Expr const *written = spelled(operand);
    return is_double(written->getType()) ? computes_with_counted(written)
                                         : may_be_symbolic(written) || is_truth_of_numbers(written);
  };
  if (auto const *unary = dyn_cast<UnaryOperator>(expression)) return takes(unary->getSubExpr());
  if (auto const *binary = dyn_cast<BinaryOperator>(expression))
    return (!binary->isCommaOp() && takes(binary->getLHS())) || takes(binary->getRHS());
  if (auto const *choice = dyn_cast<ConditionalOperator>(expression))
    return takes(choice->getTrueExpr()) || takes(choice->getFalseExpr());
  auto const *call = dyn_cast<CallExpr>(expression);
  return call && is_math(call->getDirectCallee()) && llvm::any_of(call->arguments(), takes);
}

// A comparison that keeps its condition.
bool Reals::is_truth_of_numbers(Expr const *expression) const {
  expression = spelled(expression);
  if (auto const *unary = dyn_cast<UnaryOperator>(expression))
    return unary->getOpcode() == UO_LNot && is_truth_of_numbers(unary->getSubExpr());
  if (auto const *reference = dyn_cast<DeclRefExpr>(expression)) { // auto is_above = x > 1
    auto const *variable = dyn_cast<VarDecl>(reference->getDecl());
    return variable && variable->getType()->getContainedAutoType() && variable->getType()->isBooleanType() &&
           variable->getInit() && is_truth_of_numbers(variable->getInit());
  }
  if (auto const *call = dyn_cast<CallExpr>(expression)) // isnan(x)
    return expression->getType()->isIntegerType() && is_math(call->getDirectCallee()) &&
           llvm::any_of(call->arguments(), [this](Expr const *argument) { return is_real(argument); });
  auto const *binary = dyn_cast<BinaryOperator>(expression);
  return binary && binary->isComparisonOp() && !binary->isTypeDependent() &&
         llvm::any_of(llvm::ArrayRef{binary->getLHS(), binary->getRHS()},
                      [this](Expr const *side) { return is_real(side) || may_be_symbolic(side); });
}

bool Reals::may_be_symbolic(Expr const *expression) const {
  expression = spelled(expression);
  if (expression->isTypeDependent() || !expression->getType()->isIntegerType()) return false;
  if (integer_depends(expression, [](CastExpr const *) { return true; })) return true;
  auto const counts = [this](Expr const *part) { return may_be_symbolic(part) || is_truth_of_numbers(part); };
  if (auto const *unary = dyn_cast<UnaryOperator>(expression))
    return (unary->getOpcode() == UO_Minus || unary->getOpcode() == UO_Plus || unary->getOpcode() == UO_Not) &&
           counts(unary->getSubExpr());
  if (auto const *choice = dyn_cast<ConditionalOperator>(expression))
    return may_be_symbolic(choice->getTrueExpr()) || may_be_symbolic(choice->getFalseExpr()) ||
           Numbers(*this).are_in(choice->getCond());
  auto const *binary = dyn_cast<BinaryOperator>(expression);
  if (binary && binary->isCommaOp()) return may_be_symbolic(binary->getRHS());
  return binary && !binary->isAssignmentOp() &&
         (binary->isAdditiveOp() || binary->isMultiplicativeOp() || binary->isShiftOp() || binary->isBitwiseOp()) &&
         (counts(binary->getLHS()) || counts(binary->getRHS()));
}

bool Reals::is_integer(QualType type) {
  if (type.isNull()) return false;
  type = type.getNonReferenceType();
  return type->isIntegerType() && !type->isBooleanType() && !type->isEnumeralType() && !type->isAnyCharacterType();
}

Expr const *Reals::spelled_integer(Expr const *expression) {
  while (true) {
    Expr const *inner = expression->IgnoreParens();
    if (auto const *full = dyn_cast<FullExpr>(inner)) inner = full->getSubExpr();
    if (auto const *temporary = dyn_cast<MaterializeTemporaryExpr>(inner)) inner = temporary->getSubExpr();
    if (auto const *cast = dyn_cast<ImplicitCastExpr>(inner))
      if (cast->getCastKind() == CK_LValueToRValue || cast->getCastKind() == CK_NoOp ||
          cast->getCastKind() == CK_IntegralCast)
        inner = cast->getSubExpr();
    if (inner == expression) return inner;
    expression = inner;
  }
}

bool Reals::rounds_to_integer(FunctionDecl const *function) const {
  if (!is_math(function)) return false;
  llvm::StringRef name = function->getName();
  name.consume_front("__builtin_");
  return llvm::is_contained({"lround", "llround", "lrint", "llrint"}, name);
}

bool Reals::integer_depends(Expr const *expression, llvm::function_ref<bool(CastExpr const *)> cast_does) const {
  expression = spelled_integer(expression);
  if (expression->isTypeDependent() || !is_integer(expression->getType())) return false;
  auto depends = [&](Expr const *part) { return integer_depends(part, cast_does); };
  if (auto const *cast = dyn_cast<CastExpr>(expression)) {
    // An explicit conversion in C++ has no effect by itself: its operand is the conversion.
    auto const *conversion = dyn_cast<ImplicitCastExpr>(cast->getSubExpr());
    if (cast->getCastKind() != CK_NoOp || !conversion || !conversion->isPartOfExplicitCast()) conversion = nullptr;
    CastExpr const *does = conversion ? conversion : cast;
    CastKind const kind = does->getCastKind();
    bool const converts =
        kind == CK_FloatingToIntegral
            ? is_real(does->getSubExpr())
            : (kind == CK_IntegralCast || kind == CK_NoOp || kind == CK_LValueToRValue) && depends(does->getSubExpr());
    return converts && cast_does(cast);
  }
  if (auto const *reference = dyn_cast<DeclRefExpr>(expression)) {
    auto const *variable = dyn_cast<VarDecl>(reference->getDecl());
    return variable && is_symbolic_integer(variable);
  }
  if (auto const *unary = dyn_cast<UnaryOperator>(expression))
    return (unary->getOpcode() == UO_Minus || unary->getOpcode() == UO_Plus || unary->getOpcode() == UO_Not ||
            unary->isIncrementDecrementOp()) &&
           depends(unary->getSubExpr());
  if (auto const *binary = dyn_cast<BinaryOperator>(expression)) {
    if (binary->isAssignmentOp()) return depends(binary->getLHS());
    return (binary->isAdditiveOp() || binary->isMultiplicativeOp() || binary->isShiftOp() || binary->isBitwiseOp()) &&
           (depends(binary->getLHS()) || depends(binary->getRHS()));
  }
  auto const *call = dyn_cast<CallExpr>(expression);
  FunctionDecl const *function = call ? call->getDirectCallee() : nullptr;
  if (!function) return false;
  if (external(function)) return true;
  if (rounds_to_integer(function)) return is_real(call->getArg(0));
  return is_std_function(function, {"min", "max", "clamp"}) && std::any_of(call->arg_begin(), call->arg_end(), depends);
}

bool Reals::is_symbolic_integer(Expr const *expression) const {
  return integer_depends(expression, [this](CastExpr const *cast) { return kept_casts_.contains(cast); });
}

} // namespace symreal::rewrite
