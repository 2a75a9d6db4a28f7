// Conversions of numbers within the standard library, which is not rewritten (<symreal/library_conversions.h>).
#include "rewrite/collect/collector.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

bool is_plain_number(QualType type) { return type->isArithmeticType() && !Reals::is_double(type); }

// Element type of a pointer or iterator; null for any other type.
QualType element_type(QualType iterator) {
  iterator = iterator.getNonReferenceType();
  if (iterator->isPointerType()) return iterator->getPointeeType().getUnqualifiedType();
  CXXRecordDecl const *record = iterator->getAsCXXRecordDecl();
  if (!record || !record->hasDefinition()) return {};
  for (CXXMethodDecl const *method : record->getDefinition()->methods())
    if (method->getOverloadedOperator() == OO_Star && method->getNumParams() == 0)
      return method->getReturnType().getNonReferenceType().getUnqualifiedType();
  return {};
}

bool is_of_doubles(Expr const *iterator) {
  QualType const element = element_type(iterator->getType());
  return !element.isNull() && Reals::is_double(element);
}

FunctionDecl const *called(Expr const *callable) {
  callable = callable->IgnoreImplicit();
  if (CXXRecordDecl const *lambda = callable->getType()->getAsCXXRecordDecl(); lambda && lambda->isLambda())
    return lambda->getLambdaCallOperator();
  auto const *name = dyn_cast<DeclRefExpr>(callable);
  return name ? dyn_cast<FunctionDecl>(name->getDecl()) : nullptr;
}

// Index of the output iterator among an algorithm's arguments; 0 for other functions.
unsigned output_of(llvm::StringRef algorithm, unsigned arguments) {
  if (algorithm == "copy" || algorithm == "copy_n" || algorithm == "copy_if" || algorithm == "move" ||
      algorithm == "partial_sum" || algorithm == "adjacent_difference")
    return 2;
  return algorithm == "transform" ? arguments - 2 : 0;
}

} // namespace

// A std::function with an integer or a float as its result, of a callable with a double.
void Collector::kept_callable(CXXConstructExpr const *construction) {
  auto const *type = dyn_cast<ClassTemplateSpecializationDecl>(construction->getConstructor()->getParent());
  if (!type || !type->isInStdNamespace() || type->getName() != "function" || construction->getNumArgs() != 1) return;
  auto const *signature = type->getTemplateArgs()[0].getAsType()->getAs<FunctionProtoType>();
  FunctionDecl const *function = called(construction->getArg(0));
  if (!signature || !function || !reals_.in_roots(function) || !Reals::is_double(function->getReturnType())) return;
  if (is_plain_number(signature->getReturnType()))
    wrap(construction->getArg(0)->IgnoreImplicit(), Use::before,
         "::symreal::SymrealReturning<" + spelled(signature->getReturnType()) + ">() ->*");
}

void Collector::converted_by_library(CallExpr const *call, FunctionDecl const *function) {
  if (call->isTypeDependent() || !function->getIdentifier() || call->getNumArgs() < 2) return;
  llvm::StringRef const name = function->getName();
  if (auto const *method = dyn_cast<CXXMethodDecl>(function)) {
    if (name != "assign" && name != "insert") return;
    unsigned const first = call->getNumArgs() - 2;
    Expr const *begin = call->getArg(first), *end = call->getArg(first + 1);
    auto const *container = dyn_cast<ClassTemplateSpecializationDecl>(method->getParent());
    if (!container || !container->isInStdNamespace() || !is_of_doubles(begin) || !is_of_doubles(end)) return;
    TemplateArgument const &value = container->getTemplateArgs()[0];
    if (value.getKind() != TemplateArgument::Type || !is_plain_number(value.getAsType())) return;
    for (Expr const *side : {begin, end})
      wrap(side->IgnoreImpCasts(), Use::before, "::symreal::SymrealReading<" + spelled(value.getAsType()) + ">() ->*");
    return;
  }
  if (!function->isInStdNamespace()) return;
  if (name == "accumulate" || name == "inner_product") {
    Expr const *initial = call->getNumArgs() > 2 ? call->getArg(name == "accumulate" ? 2 : 3) : nullptr;
    QualType const total = initial ? initial->getType() : QualType();
    if (initial && is_plain_number(total) && is_of_doubles(call->getArg(0)))
      wrap(initial->IgnoreImpCasts(), Use::conversion, "::symreal::SymrealTotal<" + spelled(total) + ">");
    return;
  }
  unsigned const at = output_of(name, call->getNumArgs());
  if (at == 0 || at >= call->getNumArgs()) return;
  QualType const element = element_type(call->getArg(at)->getType());
  FunctionDecl const *function_of_elements = name == "transform" ? called(call->getArg(at + 1)) : nullptr;
  bool const gives_double = name == "transform"
                                ? function_of_elements && Reals::is_double(function_of_elements->getReturnType())
                                : is_of_doubles(call->getArg(0));
  if (!element.isNull() && is_plain_number(element) && gives_double)
    wrap(call->getArg(at)->IgnoreImpCasts(), Use::before, "::symreal::SymrealWriting() ->*");
}

} // namespace symreal::rewrite
