#include "rewrite/model/effects.h"

#include "rewrite/model/storage.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// A variable that lives in a function, and no reference to something else.
VarDecl const *own_variable(Expr const *object) {
  auto const *name = dyn_cast_or_null<DeclRefExpr>(Storage::base(object));
  auto const *variable = name ? dyn_cast<VarDecl>(name->getDecl()) : nullptr;
  bool const is_own = variable && variable->hasLocalStorage() && !variable->getType()->isReferenceType();
  if (!is_own) return nullptr;
  // Storage::base looks through elements, which a pointer has elsewhere.
  return variable->getType()->isPointerType() && name != object->IgnoreParenImpCasts() ? nullptr : variable;
}

// Whether the object is *this, one of its members or their elements; not a target of a pointer or reference in it.
bool is_of_this(Expr const *object) {
  object = object->IgnoreParenImpCasts();
  if (isa<CXXThisExpr>(object)) return true;
  if (auto const *pointed = dyn_cast<UnaryOperator>(object))
    return pointed->getOpcode() == UO_Deref && isa<CXXThisExpr>(pointed->getSubExpr()->IgnoreParenImpCasts());
  if (auto const *index = dyn_cast<ArraySubscriptExpr>(object)) {
    Expr const *array = index->getBase()->IgnoreParenImpCasts();
    return array->getType()->isArrayType() && is_of_this(array);
  }
  auto const *member = dyn_cast<MemberExpr>(object);
  auto const *field = member ? dyn_cast<FieldDecl>(member->getMemberDecl()) : nullptr;
  if (!field || field->getType()->isReferenceType()) return false;
  return member->isArrow() ? isa<CXXThisExpr>(member->getBase()->IgnoreParenImpCasts()) : is_of_this(member->getBase());
}

// A function of mathematics, as the library declares it or as the compiler knows it.
bool is_mathematical(FunctionDecl const *function, Reals const &reals) {
  if (reals.is_math(function)) return true;
  return function->getBuiltinID() != 0 && function->getDeclName().isIdentifier() &&
         Reals::is_math_name(function->getName());
}

// Collects variables with other uses than of their values.
class AddressUses : public EvaluatedWalk {
public:
  bool TraverseLambdaExpr(LambdaExpr *lambda) override { // captures may be by reference
    return TraverseStmt(lambda->getBody());
  }
  bool VisitImplicitCastExpr(ImplicitCastExpr *cast) override {
    if (cast->getCastKind() == CK_LValueToRValue) by_value_.insert(Storage::base(cast->getSubExpr()));
    return true;
  }
  bool VisitBinaryOperator(BinaryOperator *binary) override {
    if (binary->isAssignmentOp()) by_value_.insert(Storage::base(binary->getLHS()));
    return true;
  }
  bool VisitUnaryOperator(UnaryOperator *unary) override {
    if (unary->isIncrementDecrementOp()) by_value_.insert(Storage::base(unary->getSubExpr()));
    return true;
  }
  bool VisitDeclRefExpr(DeclRefExpr *name) override {
    auto const *variable = dyn_cast<VarDecl>(name->getDecl());
    if (variable && (!by_value_.contains(name) || name->refersToEnclosingVariableOrCapture())) found.insert(variable);
    return true;
  }
  llvm::SmallPtrSet<VarDecl const *, 8> found;

private:
  llvm::SmallPtrSet<Expr const *, 32> by_value_;
};

} // namespace

// Whether a body changes objects other than its own.
class BodyEffects : public EvaluatedWalk {
public:
  BodyEffects(EffectAnalysis &analysis, FunctionDecl const *function) : analysis_(analysis), function_(function) {}

  bool VisitBinaryOperator(BinaryOperator *binary) override {
    return !binary->isAssignmentOp() || change(binary->getLHS());
  }
  bool VisitUnaryOperator(UnaryOperator *unary) override {
    return !unary->isIncrementDecrementOp() || change(unary->getSubExpr());
  }
  bool VisitVAArgExpr(VAArgExpr *) override { return add(EffectAnalysis::Reach::anything); }
  bool VisitAtomicExpr(AtomicExpr *) override { return add(EffectAnalysis::Reach::anything); }
  bool VisitGCCAsmStmt(GCCAsmStmt *) override { return add(EffectAnalysis::Reach::anything); }
  bool VisitCXXConstructExpr(CXXConstructExpr *construction) override {
    if (analysis_.reach(construction->getConstructor()) != EffectAnalysis::Reach::anything) return true;
    return add(EffectAnalysis::Reach::anything);
  }
  bool VisitCallExpr(CallExpr *call) override {
    EffectAnalysis::Reach const reach = analysis_.reach_of_call(call);
    if (reach != EffectAnalysis::Reach::own_object) return add(reach);
    Expr const *object = nullptr;
    if (auto const *member = dyn_cast<CXXMemberCallExpr>(call))
      object = member->getImplicitObjectArgument();
    else if (isa<CXXOperatorCallExpr>(call) && call->getNumArgs() > 0)
      object = call->getArg(0);
    if (!object) return true;
    bool const is_pointee = object->getType()->isPointerType() && !isa<CXXThisExpr>(object->IgnoreParenImpCasts());
    return is_pointee ? add(EffectAnalysis::Reach::anything) : change(object);
  }
  EffectAnalysis::Reach result = EffectAnalysis::Reach::none;

private:
  bool add(EffectAnalysis::Reach reach) {
    result = std::max(result, reach);
    return result != EffectAnalysis::Reach::anything;
  }
  bool change(Expr const *object) {
    object = object->IgnoreParenImpCasts();
    if (auto const *temporary = dyn_cast<MaterializeTemporaryExpr>(object); temporary || object->isPRValue()) {
      if (!object->getType()->isPointerType()) return true;
    }
    if (VarDecl const *variable = own_variable(object); variable && variable->getDeclContext() == function_)
      return true;
    return add(is_of_this(object) ? EffectAnalysis::Reach::own_object : EffectAnalysis::Reach::anything);
  }

  EffectAnalysis &analysis_;
  FunctionDecl const *function_;
};

EffectAnalysis::Reach EffectAnalysis::reach(FunctionDecl const *function) {
  if (is_mathematical(function, reals_)) return Reach::none;
  if (Reals::External const *external = reals_.external(function))
    return external->pure ? Reach::none : Reach::anything;
  FunctionDecl const *definition = nullptr;
  if (!function->isDefined(definition) || !definition->getBody()) {
    bool const is_harmless = function->hasAttr<ConstAttr>() || function->hasAttr<PureAttr>() ||
                             function->isNoReturn() || function->isTrivial() || function->isDefaulted();
    return is_harmless ? Reach::none : Reach::anything;
  }
  auto const [at, is_new] = reach_.try_emplace(definition, Reach::none); // for a call of itself
  if (!is_new) return at->second;
  BodyEffects effects(*this, definition);
  effects.TraverseStmt(definition->getBody());
  if (auto const *constructor = dyn_cast<CXXConstructorDecl>(definition)) {
    for (CXXCtorInitializer const *initializer : constructor->inits())
      if (initializer->getInit()) effects.TraverseStmt(initializer->getInit());
  }
  return reach_[definition] = effects.result;
}

EffectAnalysis::Reach EffectAnalysis::reach_of_call(CallExpr const *call) {
  FunctionDecl const *function = call->getDirectCallee();
  if (!function) return Reach::anything;
  auto const *method = dyn_cast<CXXMethodDecl>(function);
  if (method && method->isVirtual() && !isa<CXXOperatorCallExpr>(call) && reals_.in_roots(method))
    return Reach::anything; // which of them is called is not known
  return reach(function);
}

// A function of a library that gets no address of the program's objects.
bool EffectAnalysis::only_talks(CallExpr const *call) const {
  FunctionDecl const *function = call->getDirectCallee();
  if (!function || isa<CXXMethodDecl>(function) || reals_.in_roots(function) || function->isDefined()) return false;
  for (Expr const *argument : call->arguments()) {
    QualType const pointee = argument->getType()->getPointeeType();
    if (argument->isGLValue() || argument->getType()->isRecordType()) return false;
    if (!pointee.isNull() && !pointee.isConstQualified()) return false;
  }
  return true;
}

llvm::SmallPtrSet<VarDecl const *, 8> const &EffectAnalysis::known_elsewhere(FunctionDecl const *function) {
  auto const [at, is_new] = known_elsewhere_.try_emplace(function);
  if (is_new && function->getBody()) {
    AddressUses uses;
    uses.TraverseStmt(function->getBody());
    at->second = std::move(uses.found);
  }
  return at->second;
}

class OperandEffects : public EvaluatedWalk {
public:
  OperandEffects(EffectAnalysis &analysis, FunctionDecl const *function) : analysis_(analysis), function_(function) {}

  bool VisitImplicitCastExpr(ImplicitCastExpr *cast) override {
    if (cast->getCastKind() == CK_LValueToRValue) result.reads |= is_known_elsewhere(cast->getSubExpr());
    return true;
  }
  bool VisitCXXConstructExpr(CXXConstructExpr *construction) override {
    result.reads |= construction->getNumArgs() > 0; // its arguments are copied
    result.changes |= analysis_.reach(construction->getConstructor()) == EffectAnalysis::Reach::anything;
    return true;
  }
  bool VisitCallExpr(CallExpr *call) override {
    FunctionDecl const *function = call->getDirectCallee();
    result.reads |= !function || !is_mathematical(function, analysis_.reals_);
    if (analysis_.reach_of_call(call) == EffectAnalysis::Reach::none) return true;
    if (analysis_.only_talks(call))
      result.talks |= !function->isVariadic(); // in which order it prints changes no number
    else
      result.changes = true;
    return true;
  }
  bool VisitVAArgExpr(VAArgExpr *) override { return result.changes = true; }
  bool VisitAtomicExpr(AtomicExpr *) override { return result.changes = true; }
  bool VisitStmtExpr(StmtExpr *) override { return result.changes = true; }
  bool VisitBinaryOperator(BinaryOperator *binary) override {
    if (binary->isAssignmentOp()) result.changes |= is_known_elsewhere(binary->getLHS());
    return true;
  }
  bool VisitUnaryOperator(UnaryOperator *unary) override {
    if (unary->isIncrementDecrementOp()) result.changes |= is_known_elsewhere(unary->getSubExpr());
    return true;
  }
  Effects result;

private:
  bool is_known_elsewhere(Expr const *object) {
    if (object->getType().isConstQualified() && isa<DeclRefExpr>(object->IgnoreParenImpCasts())) return false;
    VarDecl const *variable = own_variable(object);
    return !variable || !function_ || analysis_.known_elsewhere(function_).contains(variable);
  }

  EffectAnalysis &analysis_;
  FunctionDecl const *function_;
};

Effects EffectAnalysis::of(Expr const *operand, FunctionDecl const *function) {
  OperandEffects effects(*this, function);
  effects.TraverseStmt(const_cast<Expr *>(operand));
  return effects.result;
}

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
