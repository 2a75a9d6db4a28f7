#include "rewrite/model/storage.h"

#include "rewrite/model/library.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

llvm::StringRef name_in(QualType type, llvm::StringRef space) {
  auto const *record = type.isNull() ? nullptr : type.getNonReferenceType()->getAsCXXRecordDecl();
  if (!record || !record->getIdentifier()) return {};
  auto const *scope = dyn_cast<NamespaceDecl>(record->getDeclContext()->getEnclosingNamespaceContext());
  while (scope && scope->isInlineNamespace()) scope = dyn_cast<NamespaceDecl>(scope->getDeclContext());
  return scope && scope->getName() == space ? record->getName() : llvm::StringRef();
}

bool has(QualType type, library::Class trait) {
  for (llvm::StringRef scope : {"std", "Eigen"})
    if (llvm::StringRef const name = name_in(type, scope); !name.empty() && library::has(scope, name, trait))
      return true;
  return false;
}

// Whether the pointee is an object; text and functions are checked where they decide.
bool leads_to_object(QualType type) {
  QualType const target = type->getPointeeType();
  return !target.isNull() && !target->isFunctionType() && !target->isAnyCharacterType() && !type->isMemberPointerType();
}

bool holds_pointers(QualType type, llvm::SmallPtrSetImpl<Type const *> &seen) {
  type = type.getCanonicalType().getUnqualifiedType();
  if (leads_to_object(type) || type->isDependentType()) return true;
  if (!seen.insert(type.getTypePtr()).second) return false;
  if (auto const *array = type->getAsArrayTypeUnsafe()) return holds_pointers(array->getElementType(), seen);
  RecordDecl const *record = type->getAsRecordDecl();
  if (!record || !record->getDefinition() || has(type, library::VALUE)) return false;
  auto const inner = [&seen](QualType part) { return holds_pointers(part, seen); };
  if (has(type, library::OWNS_ELEMENTS)) {
    auto const *special = dyn_cast<ClassTemplateSpecializationDecl>(record);
    return special && any_type_argument(special, leads_to_object);
  }
  if (auto const *derived = dyn_cast<CXXRecordDecl>(record->getDefinition()))
    if (llvm::any_of(derived->bases(), [&](CXXBaseSpecifier const &base) { return inner(base.getType()); }))
      return true;
  return llvm::any_of(record->getDefinition()->fields(),
                      [&](FieldDecl const *field) { return inner(field->getType()); });
}

} // namespace

bool Storage::holds_pointer(QualType type) {
  llvm::SmallPtrSet<Type const *, 8> seen;
  return holds_pointers(type, seen);
}

std::string Storage::lead_from(VarDecl const *variable) {
  std::string const name = variable->getName().str();
  if (name.empty()) return "";
  QualType const type = variable->getType();
  if (type->isReferenceType())
    return type->getPointeeType()->isFunctionType() ? "" : "__builtin_addressof(" + name + ")";
  return holds_pointer(type) ? name : "";
}

bool any_type_argument(ClassTemplateSpecializationDecl const *special, llvm::function_ref<bool(QualType)> is_one) {
  auto const holds = [is_one](TemplateArgument const &argument) {
    return argument.getKind() == TemplateArgument::Type && is_one(argument.getAsType());
  };
  return llvm::any_of(special->getTemplateArgs().asArray(), [&](TemplateArgument const &argument) {
    return argument.getKind() == TemplateArgument::Pack ? llvm::any_of(argument.pack_elements(), holds)
                                                        : holds(argument);
  });
}

bool selects_argument(FunctionDecl const *function) {
  return function->isInStdNamespace() && function->getDeclName().isIdentifier() &&
         library::has(function->getName(), library::GIVES_ARGUMENT);
}

Expr const *spelled_expression(Expr const *expression) {
  while (true) {
    Expr const *inner = expression->IgnoreParenImpCasts();
    if (auto const *full = dyn_cast<FullExpr>(inner))
      inner = full->getSubExpr();
    else if (auto const *temporary = dyn_cast<MaterializeTemporaryExpr>(inner))
      inner = temporary->getSubExpr();
    else if (auto const *bound = dyn_cast<CXXBindTemporaryExpr>(inner))
      inner = bound->getSubExpr();
    if (inner == expression) return inner;
    expression = inner;
  }
}

Expr const *Storage::object_of(CallExpr const *call) {
  if (auto const *member = dyn_cast<CXXMemberCallExpr>(call)) return member->getImplicitObjectArgument();
  if (isa<CXXOperatorCallExpr>(call) && isa_and_nonnull<CXXMethodDecl>(call->getDirectCallee())) return call->getArg(0);
  return nullptr;
}

bool Storage::is_view(QualType type) { return has(type, library::VIEW); }

bool Storage::lends(QualType type) { return has(type, library::VIEW) || has(type, library::LENDS); }

bool Storage::owns_elements(QualType type) { return has(type, library::OWNS_ELEMENTS); }

Expr const *Storage::base(Expr const *expression) {
  while (true) {
    expression = spelled_expression(expression);
    if (auto const *member = dyn_cast<MemberExpr>(expression)) {
      if (isa<VarDecl>(member->getMemberDecl()) || member->isArrow()) return member;
      expression = member->getBase();
    } else if (auto const *index = dyn_cast<ArraySubscriptExpr>(expression))
      expression = index->getBase();
    else if (auto const *call = dyn_cast<CallExpr>(expression); call && object_of(call))
      expression = object_of(call);
    else
      return isa<DeclRefExpr>(expression) ? expression : nullptr;
  }
}

// A reference of static storage duration, or a constant pointer, to a const object of that duration; a temporary too.
bool Storage::leads_to_constant(VarDecl const *variable) const {
  if (!followed_.insert(variable).second) return false; // it leads to itself
  bool const leads = target_is_constant(variable);
  followed_.erase(variable);
  return leads;
}

bool Storage::target_is_constant(VarDecl const *variable) const {
  VarDecl const *definition = nullptr;
  Expr const *target = variable->getAnyInitializer(definition);
  if (!target || target->isInstantiationDependent()) return false;
  QualType const type = variable->getType();
  target = target->IgnoreParens();
  if (auto const *full = dyn_cast<FullExpr>(target)) target = full->getSubExpr()->IgnoreParens();
  if (type->isReferenceType()) {
    auto const *temporary = dyn_cast<MaterializeTemporaryExpr>(target);
    if (temporary && temporary->getStorageDuration() != SD_FullExpression)
      return type.getNonReferenceType().isConstQualified();
    return home(target) == Home::constant;
  }
  if (!type->isPointerType() || !type.isConstQualified()) return false;
  target = spelled_expression(target);
  if (target->getType()->isArrayType()) return home(target) == Home::constant;
  auto const *address = dyn_cast<UnaryOperator>(target);
  return address && address->getOpcode() == UO_AddrOf && home(address->getSubExpr()) == Home::constant;
}

// Storage of the pointer's target.
Home Storage::home_behind(Expr const *pointer) const {
  auto const *reference = dyn_cast<DeclRefExpr>(spelled_expression(pointer));
  auto const *variable = reference ? dyn_cast<VarDecl>(reference->getDecl()) : nullptr;
  return variable && leads_to_constant(variable) ? Home::constant : Home::elsewhere;
}

Home Storage::home_of(ValueDecl const *declaration, bool is_captured) const {
  if (auto const *binding = dyn_cast<BindingDecl>(declaration)) {
    auto const *whole = dyn_cast_or_null<VarDecl>(binding->getDecomposedDecl());
    return whole && whole->getType()->isReferenceType() ? Home::elsewhere : Home::local;
  }
  auto const *variable = dyn_cast<VarDecl>(declaration);
  if (!variable) return Home::local;
  if (variable->isConstexpr()) return Home::constant;
  if (variable->hasGlobalStorage()) {
    if (reals_.is_passive(variable)) return Home::constant;
    if (variable->getType()->isReferenceType()) return leads_to_constant(variable) ? Home::constant : Home::elsewhere;
    bool const is_const = variable->getASTContext().getBaseElementType(variable->getType()).isConstQualified();
    return is_const ? Home::constant : Home::elsewhere;
  }
  return variable->getType()->isReferenceType() || is_captured ? Home::elsewhere : Home::local;
}

Home Storage::home_of_call(CallExpr const *call) const {
  Expr const *object = object_of(call);
  FunctionDecl const *function = call->getDirectCallee();
  if (function && selects_argument(function)) return Home::local; // the arguments are checked themselves
  if (!object || !function) return call->isGLValue() ? Home::elsewhere : Home::local;
  if (!call->isGLValue() && !is_view(call->getType())) return Home::local;
  bool const known = owns_elements(object->getType()) || is_view(object->getType());
  Home const at = home(object);
  if (at == Home::local && !known) return Home::elsewhere;
  // A constant object may lead to others that are not.
  bool const is_part = !lends(object->getType()) && !has(object->getType(), library::POINTER) &&
                       (owns_elements(object->getType()) || call->getType().isConstQualified());
  return at == Home::constant && !is_part ? Home::elsewhere : at;
}

Home Storage::home(Expr const *expression) const {
  expression = spelled_expression(expression);
  if (auto const *reference = dyn_cast<DeclRefExpr>(expression)) {
    Home const at = home_of(reference->getDecl(), reference->refersToEnclosingVariableOrCapture());
    return at == Home::local && is_view(reference->getType()) ? Home::elsewhere : at;
  }
  if (auto const *member = dyn_cast<MemberExpr>(expression)) {
    if (auto const *variable = dyn_cast<VarDecl>(member->getMemberDecl())) return home_of(variable, false);
    if (member->isArrow() || member->getMemberDecl()->getType()->isReferenceType()) return Home::elsewhere;
    if (is_view(member->getType())) return Home::elsewhere;
    Home const at = home(member->getBase());
    bool const is_mutable = cast<FieldDecl>(member->getMemberDecl())->isMutable();
    return at == Home::constant && is_mutable ? Home::elsewhere : at;
  }
  if (auto const *index = dyn_cast<ArraySubscriptExpr>(expression)) {
    Expr const *array = index->getBase()->IgnoreParenImpCasts();
    return array->getType()->isArrayType() ? home(array) : home_behind(array);
  }
  if (auto const *pointed = dyn_cast<UnaryOperator>(expression); pointed && pointed->getOpcode() == UO_Deref)
    return home_behind(pointed->getSubExpr());
  if (auto const *call = dyn_cast<CallExpr>(expression)) return home_of_call(call);
  if (auto const *cast = dyn_cast<ExplicitCastExpr>(expression); cast && cast->isGLValue())
    return home(cast->getSubExpr());
  return expression->isGLValue() ? Home::elsewhere : Home::local;
}

} // namespace symreal::rewrite
