// Questions of a program for the name of a type: typeid, related functions of the standard library, and
// __PRETTY_FUNCTION__. A class replaces double, and the runtime returns the names of the original.
#include "rewrite/collect/collector.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

bool is_of_std(Expr const *object, llvm::StringRef name) {
  QualType const type = object->getType().getNonReferenceType();
  CXXRecordDecl const *record = (type->isPointerType() ? type->getPointeeType() : type)->getAsCXXRecordDecl();
  return record && record->isInStdNamespace() && record->getDeclName().isIdentifier() && record->getName() == name;
}

// The instantiation of a template, or with a number among the types of its parameters.
bool shows_type(FunctionDecl const *function, Reals const &reals) {
  for (DeclContext const *context = function; context && !context->isFileContext(); context = context->getParent()) {
    auto const *one = dyn_cast<FunctionDecl>(context);
    if (context->isDependentContext() || isa<ClassTemplateSpecializationDecl>(context)) return true;
    if (one && (one->isTemplateInstantiation() || reals.mentions_real(one->getType()))) return true;
  }
  return false;
}

} // namespace

// `place`: as source text; empty for a mere comparison of types.
void Collector::type_asked(SourceLocation user, Expr const *expression, std::string const &place) {
  SourceLocation const begin = expression->getBeginLoc();
  if (!map_.in_roots(begin) || !map_.language().CPlusPlus) return;
  if (std::optional<Span> const span = map_.range_for(user, expression->getSourceRange())) {
    facts_.wraps.insert({*span, Use::named, place});
    return;
  }
  auto const *type = dyn_cast<CXXTypeidExpr>(expression); // in the body of a library's macro
  if (type && type->isTypeOperand() && reals_.mentions_real(type->getTypeOperand(context_)))
    report(DiagnosticId::split_expression, begin, "a macro makes a part of this expression, which needs a conversion");
}

void Collector::type_asked(CXXTypeidExpr const *type) { type_asked(type->getBeginLoc(), type, "nullptr"); }

void Collector::type_asked(CXXMemberCallExpr const *call) {
  CXXMethodDecl const *method = call->getMethodDecl();
  if (!method || !method->getParent()->isInStdNamespace() || !method->getDeclName().isIdentifier()) return;
  llvm::StringRef const asked = method->getName();
  Expr const *object = call->getImplicitObjectArgument()->IgnoreParenImpCasts();
  auto const named = [&](Expr const *expression) {
    type_asked(call->getRParenLoc(), expression, in_quotes(to_string(map_.place(expression->getBeginLoc()))));
  };
  if (asked == "function_name" && is_of_std(object, "source_location")) return named(call);
  // std::any::type(), std::function::target_type()
  if (is_of_std(call, "type_info")) return type_asked(call->getRParenLoc(), call, "nullptr");
  bool const is_type = is_of_std(object, "type_info") || is_of_std(object, "type_index");
  if (!is_type || (asked != "name" && asked != "hash_code" && asked != "before")) return;
  named(object);
  for (Expr const *other : call->arguments()) named(other->IgnoreParenImpCasts());
}

void Collector::signature_asked(PredefinedExpr const *name, FunctionDecl const *function) {
  if (!map_.language().CPlusPlus || name->getIdentKind() != PredefinedIdentKind::PrettyFunction) return;
  if (!shows_type(function, reals_)) return;
  std::optional<Span> const token = map_.token(name->getLocation(), "__PRETTY_FUNCTION__");
  if (token && !map_.is_argument_of(name->getLocation(), "REAL_EITHER"))
    facts_.wraps.insert({*token, Use::instead, "SYMREAL_SIGNATURE"});
}

} // namespace symreal::rewrite
