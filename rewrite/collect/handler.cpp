#include "rewrite/collect/handler.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
using namespace clang;

void SyntaxHandler::report(DiagnosticId id, SourceLocation location, std::string message,
                           std::optional<Severity> unusual) {
  Diagnostic diagnostic{id, map_.place(location), std::move(message), map_.expansions(location)};
  if (instance_) diagnostic.notes.push_back(*instance_);
  if (unusual) diagnostic.severity = *unusual;
  add_diagnostic(facts_, diagnostic);
}

void SyntaxHandler::wrap(Expr const *expression, Use use, std::string detail) {
  wrap_for({}, expression, use, std::move(detail));
}

std::optional<Span> SyntaxHandler::wrap_for(SourceLocation user, Expr const *expression, Use use, std::string detail) {
  SourceLocation const begin = expression->getBeginLoc();
  if (!map_.in_roots(begin)) return std::nullopt;
  std::optional<Span> span = map_.range_for(user, expression->getSourceRange());
  // The parentheses may be those of a library's macro around its argument.
  for (Expr const *inner = expression; !span;) {
    auto const *parens = dyn_cast<ParenExpr>(inner->IgnoreImplicit());
    if (!parens) break;
    inner = parens->getSubExpr();
    span = map_.range(inner->getSourceRange());
  }
  if (span)
    facts_.wraps.insert({*span, use, std::move(detail)});
  else
    report(DiagnosticId::split_expression, begin, "a macro makes a part of this expression, which needs a conversion");
  return span;
}

void SyntaxHandler::convert(Expr const *expression, Use use, std::string type) {
  std::optional<Span> const span = wrap_for({}, expression, use, std::move(type));
  if (span && map_.is_shared(expression->getSourceRange())) facts_.shared.insert(*span);
}

std::string SyntaxHandler::spelled(QualType type) const {
  while (auto const *named = type->getAs<TypedefType>()) {
    if (named->getDecl()->getDeclContext()->getRedeclContext()->isTranslationUnit()) break;
    type = named->desugar();
  }
  PrintingPolicy policy(map_.language());
  policy.Bool = true; // C's _Bool is compiled as C++ where it matters
  return with_real(type.getUnqualifiedType().getAsString(policy));
}

bool SyntaxHandler::is_plain_double(Expr const *expression) const {
  return Reals::is_double(expression->getType()) && !expression->isTypeDependent() && reals_.stays_double(expression);
}

llvm::ArrayRef<Expr *> SyntaxHandler::converted_elements(InitListExpr const *list) {
  InitListExpr const *complete = list->isSemanticForm() ? list : list->getSemanticForm();
  if (!complete || complete->isTypeDependent()) return {};
  return complete->inits();
}

} // namespace symreal::rewrite
