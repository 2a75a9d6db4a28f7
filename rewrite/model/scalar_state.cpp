#include "rewrite/model/scalar_state.h"

#include "rewrite/model/library.h"
#include "rewrite/model/storage.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

VarDecl const *visible_here_only(Decl const *declaration) {
  auto const *variable = dyn_cast<VarDecl>(declaration);
  if (!variable || !variable->hasGlobalStorage()) return nullptr;
  return variable->isStaticLocal() || !variable->isExternallyVisible() ? variable->getCanonicalDecl() : nullptr;
}

// The name at the base of elements and members, if the expression is part of that object.
DeclRefExpr const *part_of(Expr const *expression) {
  while (true) {
    expression = expression->IgnoreParens();
    if (auto const *decay = dyn_cast<ImplicitCastExpr>(expression); decay && decay->getCastKind() != CK_LValueToRValue)
      expression = decay->getSubExpr();
    else if (auto const *index = dyn_cast<ArraySubscriptExpr>(expression))
      expression = index->getBase();
    else if (auto const *sum = dyn_cast<BinaryOperator>(expression); sum && sum->getOpcode() == BO_Add)
      expression = sum->getLHS(); // the end of a range
    else if (auto const *member = dyn_cast<MemberExpr>(expression); member && !member->isArrow())
      expression = member->getBase();
    else
      return dyn_cast<DeclRefExpr>(expression);
  }
}

// Every mention of a variable, but for those that only look at its value.
class Touched : public Walk {
public:
  Touched(llvm::DenseSet<VarDecl const *> &touched, bool removes_const)
      : touched_(touched),
        removes_const_(removes_const) {}

  bool TraverseUnaryExprOrTypeTraitExpr(UnaryExprOrTypeTraitExpr *) override { return true; }
  bool VisitImplicitCastExpr(ImplicitCastExpr *cast) override {
    QualType const object = cast->isGLValue() ? cast->getType() : cast->getType()->getPointeeType();
    bool const converts = cast->getCastKind() == CK_NoOp || cast->getCastKind() == CK_UncheckedDerivedToBase ||
                          cast->getCastKind() == CK_DerivedToBase;
    bool const adds_const =
        converts && !object.isNull() && object.isConstQualified() && !removes_const_ && !has_mutable(object);
    if (adds_const || cast->getCastKind() == CK_LValueToRValue) looked_at_.insert(part_of(cast->getSubExpr()));
    return true;
  }
  bool VisitCXXForRangeStmt(CXXForRangeStmt *loop) override {
    QualType const type = loop->getLoopVariable()->getType();
    if (!type->isReferenceType() || type.getNonReferenceType().isConstQualified())
      looked_at_.insert(part_of(loop->getRangeInit()));
    return true;
  }
  // std::count(a, a + n, v), and std::find(a, a + n, v) - a: their results are not written through.
  bool VisitCallExpr(CallExpr *call) override {
    if (!call->getType()->isPointerType()) only_reads(call);
    return true;
  }
  bool VisitBinaryOperator(BinaryOperator *binary) override {
    bool const subtracts = binary->getOpcode() == BO_Sub && binary->getRHS()->getType()->isPointerType();
    if (!subtracts && !binary->isComparisonOp()) return true;
    for (Expr const *side : {binary->getLHS(), binary->getRHS()})
      if (auto const *call = dyn_cast<CallExpr>(side->IgnoreParenImpCasts()))
        only_reads(call);
      else if (side->getType()->isPointerType())
        looked_at_.insert(part_of(side));
    return true;
  }
  bool VisitDeclRefExpr(DeclRefExpr *reference) override {
    if (VarDecl const *variable = visible_here_only(reference->getDecl()); variable && !looked_at_.contains(reference))
      touched_.insert(variable);
    return true;
  }
  bool VisitMemberExpr(MemberExpr *member) override {
    if (VarDecl const *variable = visible_here_only(member->getMemberDecl())) touched_.insert(variable);
    return true;
  }

private:
  void only_reads(CallExpr const *call) {
    FunctionDecl const *function = call->getDirectCallee();
    if (!function || !function->isInStdNamespace() || !function->getIdentifier() ||
        !library::has(function->getName(), library::ONLY_READS))
      return;
    for (Expr const *argument : call->arguments())
      if (argument->getType()->isPointerType()) looked_at_.insert(part_of(argument));
  }

  static bool has_mutable(QualType type) {
    auto const *record = type->getAsCXXRecordDecl();
    return record && record->hasDefinition() && record->hasMutableFields();
  }

  llvm::DenseSet<VarDecl const *> &touched_;
  bool removes_const_;
  llvm::SmallPtrSet<DeclRefExpr const *, 32> looked_at_;
};

// Indirect changes of apparently constant variables: through a cast that removes const, and through a constructor that
// lets the object's address escape.
class Detours : public Walk {
public:
  explicit Detours(SourceMap const &map) : map_(map) {}

  bool VisitCXXConstructorDecl(CXXConstructorDecl *constructor) override {
    constructor_ = constructor->isUserProvided() && map_.in_roots(constructor->getLocation()) ? constructor : nullptr;
    return true;
  }
  bool VisitFunctionDecl(FunctionDecl *function) override {
    if (!isa<CXXConstructorDecl>(function)) constructor_ = nullptr;
    return true;
  }
  bool VisitMemberExpr(MemberExpr *member) override {
    within_.insert(member->getBase()->IgnoreParenImpCasts());
    return true;
  }
  bool VisitUnaryOperator(UnaryOperator *unary) override {
    auto const *member = dyn_cast<MemberExpr>(unary->getSubExpr()->IgnoreParenImpCasts());
    if (constructor_ && unary->getOpcode() == UO_AddrOf && member && isa<CXXThisExpr>(member->getBase()))
      leaks.insert(constructor_->getParent()->getCanonicalDecl());
    return true;
  }
  bool VisitCXXThisExpr(CXXThisExpr *self) override {
    if (constructor_ && !within_.contains(self)) leaks.insert(constructor_->getParent()->getCanonicalDecl());
    return true;
  }
  bool VisitExplicitCastExpr(ExplicitCastExpr *cast) override {
    if (!map_.in_roots(cast->getBeginLoc()) || cast->isTypeDependent()) return true;
    QualType const to = cast->getTypeAsWritten();
    QualType const target = to->getPointeeType(), source = cast->isGLValue()
                                                               ? cast->getSubExpr()->getType()
                                                               : cast->getSubExpr()->getType()->getPointeeType();
    if (!target.isNull() && !source.isNull() && source.isConstQualified() && !target.isConstQualified())
      removes_const = true;
    return true;
  }

  llvm::SmallPtrSet<CXXRecordDecl const *, 4> leaks;
  bool removes_const = false;

private:
  SourceMap const &map_;
  CXXConstructorDecl const *constructor_ = nullptr;
  llvm::SmallPtrSet<Expr const *, 16> within_;
};

bool is_container(ClassTemplateSpecializationDecl const *record) {
  return record->isInStdNamespace() && record->getIdentifier() &&
         library::has("std", record->getName(), library::OWNS_SCALARS);
}

} // namespace

ScalarState::ScalarState(ASTContext &context, SourceMap const &map) : map_(map) {
  Detours detours(map);
  for (Decl *one : context.getTranslationUnitDecl()->decls())
    if (map.in_roots(one->getLocation())) detours.TraverseDecl(one);
  leaks_ = std::move(detours.leaks);
  Touched(touched_, detours.removes_const).TraverseDecl(context.getTranslationUnitDecl());
}

bool ScalarState::is_integer(QualType type) {
  return !type.isNull() && !type->isDependentType() && type.getNonReferenceType()->isIntegralOrEnumerationType() &&
         !type->isBitIntType();
}

bool ScalarState::is_floating(QualType type) {
  if (type.isNull() || type->isDependentType()) return false;
  type = type.getNonReferenceType();
  return type->isSpecificBuiltinType(BuiltinType::Float) || type->isSpecificBuiltinType(BuiltinType::LongDouble);
}

bool ScalarState::is_function_pointer(QualType type) {
  if (type.isNull() || type->isDependentType()) return false;
  type = type.getNonReferenceType();
  return type->isFunctionPointerType() || type->isMemberPointerType();
}

// A class of the standard library, in a namespace within std too.
static CXXRecordDecl const *standard_class(QualType type) {
  CXXRecordDecl const *record = type.getNonReferenceType()->getAsCXXRecordDecl();
  if (!record || !record->getIdentifier()) return nullptr;
  for (DeclContext const *scope = record->getDeclContext(); scope->isNamespace(); scope = scope->getParent())
    if (scope->isStdNamespace()) return record;
  return nullptr;
}

bool ScalarState::has_value_of_its_own(QualType type) {
  CXXRecordDecl const *record = standard_class(type);
  if (!record) return false;
  if (library::has("std", record->getName(), library::VALUE)) return true;
  auto const *special = dyn_cast<ClassTemplateSpecializationDecl>(record);
  return special && special->getName() == "vector" && special->getTemplateArgs()[0].getAsType()->isBooleanType();
}

bool ScalarState::is_smart_pointer(QualType type) {
  CXXRecordDecl const *record = standard_class(type);
  return record && library::has("std", record->getName(), library::POINTER);
}

bool ScalarState::is_opaque(QualType type) {
  return has_value_of_its_own(type) &&
         !library::has("std", type.getNonReferenceType()->getAsCXXRecordDecl()->getName(), library::OWNS_SCALARS);
}

bool ScalarState::is_copied(CXXRecordDecl const *record) {
  if (record->isEmpty() || record->isLambda()) return false;
  if (record->needsImplicitCopyConstructor()) return !record->defaultedCopyConstructorIsDeleted();
  return llvm::any_of(record->ctors(),
                      [](CXXConstructorDecl const *one) { return one->isCopyConstructor() && !one->isDeleted(); });
}

// Whether the record is a union without numbers.
static bool is_plain_union(RecordDecl const *record) {
  return record->isUnion() && llvm::none_of(record->fields(), [](FieldDecl const *field) {
           QualType const type = field->getType()->getBaseElementTypeUnsafe()->getCanonicalTypeUnqualified();
           RecordDecl const *part = type->getAsRecordDecl();
           return type->isDependentType() || type->isSpecificBuiltinType(BuiltinType::Double) ||
                  type->isComplexType() || part != nullptr;
         });
}

bool ScalarState::is_unknown(QualType type) const {
  // A union, or in C a structure of a library, such as struct tm.
  if (RecordDecl const *plain = type.isNull() ? nullptr : type.getNonReferenceType()->getAsRecordDecl();
      plain && plain->getDefinition() &&
      (is_plain_union(plain->getDefinition()) || (!isa<CXXRecordDecl>(plain) && !map_.in_roots(plain->getLocation()))))
    return true;
  CXXRecordDecl const *record = type.isNull() ? nullptr : type.getNonReferenceType()->getAsCXXRecordDecl();
  if (!record || !record->getIdentifier() || !record->hasDefinition() || map_.in_roots(record->getLocation()))
    return false;
  record = record->getDefinition();
  auto const *special = dyn_cast<ClassTemplateSpecializationDecl>(record);
  bool const of_function = special && special->getName() == "reference_wrapper" &&
                           special->getTemplateArgs()[0].getAsType()->isFunctionType();
  if (of_function) return true;
  if (standard_class(type) && library::has("std", record->getName(), library::ANY)) return false;
  for (DeclContext const *scope = record->getDeclContext(); !scope->isTranslationUnit(); scope = scope->getParent())
    if (auto const *space = dyn_cast<NamespaceDecl>(scope); space && space->getName() == "Eigen") return false;
  ASTContext &context = record->getASTContext();
  DeclarationName const of_iterators(&context.Idents.get("iterator_category"));
  return is_copied(record) && record->lookup(of_iterators).empty();
}

bool ScalarState::holds(QualType type, llvm::SmallPtrSetImpl<Type const *> &seen) const {
  if (type.isNull() || type->isDependentType() || type->isReferenceType()) return false;
  type = type.getCanonicalType().getUnqualifiedType();
  if (is_scalar(type)) return true;
  if (!seen.insert(type.getTypePtr()).second) return false;
  if (auto const *array = type->getAsArrayTypeUnsafe())
    return !is_text_character(array->getElementType()) && holds(array->getElementType(), seen);
  if (has_value_of_its_own(type)) return true;
  auto const *record = type->getAsRecordDecl();
  if (!record) return false;
  if (auto const *special = dyn_cast<ClassTemplateSpecializationDecl>(record); special && is_container(special)) {
    return any_type_argument(special, [&](QualType one) { return !is_text_character(one) && holds(one, seen); });
  }
  record = map_.in_roots(record->getLocation()) ? record->getDefinition() : nullptr;
  if (!record || record->isUnion()) return false;
  if (auto const *derived = dyn_cast<CXXRecordDecl>(record))
    for (CXXBaseSpecifier const &base : derived->bases())
      if (holds(base.getType(), seen)) return true;
  for (FieldDecl const *field : record->fields())
    if (holds(field->getType(), seen)) return true;
  return false;
}

bool ScalarState::holds(QualType type) const {
  llvm::SmallPtrSet<Type const *, 16> seen;
  return holds(type, seen);
}

bool ScalarState::is_fixed(VarDecl const *variable) const {
  VarDecl const *here = visible_here_only(variable);
  if (variable->getType()->isReferenceType()) return false; // the object that it names may change
  auto const *record = variable->getType()->getBaseElementTypeUnsafe()->getAsCXXRecordDecl();
  if (record && leaks_.contains(record->getCanonicalDecl())) return false;
  return here && !touched_.contains(here);
}

bool ScalarState::has_address(FieldDecl const *field) {
  return !field->isBitField() && !field->hasAttr<PackedAttr>() && !field->getParent()->hasAttr<PackedAttr>();
}

bool ScalarState::has_address(Expr const *expression) {
  if (expression->getObjectKind() != OK_Ordinary) return false;
  auto const *member = dyn_cast<MemberExpr>(expression->IgnoreParens());
  auto const *field = member ? dyn_cast<FieldDecl>(member->getMemberDecl()) : nullptr;
  return !field || has_address(field);
}

} // namespace symreal::rewrite
