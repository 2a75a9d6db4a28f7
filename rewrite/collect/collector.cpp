#include "rewrite/collect/collector.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// `x`, `p->x`, `x[i]`, `*x`: x.
llvm::StringRef name_of(Expr const *target) {
  target = target->IgnoreParenImpCasts();
  if (auto const *element = dyn_cast<ArraySubscriptExpr>(target)) return name_of(element->getBase());
  if (auto const *pointee = dyn_cast<UnaryOperator>(target); pointee && pointee->getOpcode() == UO_Deref)
    return name_of(pointee->getSubExpr());
  NamedDecl const *declaration = nullptr;
  if (auto const *reference = dyn_cast<DeclRefExpr>(target)) declaration = reference->getDecl();
  if (auto const *member = dyn_cast<MemberExpr>(target)) declaration = member->getMemberDecl();
  return declaration && declaration->getIdentifier() ? declaration->getName() : llvm::StringRef();
}

} // namespace

void Collector::finish() {
  for (std::size_t k = 0; k < waiting_.size(); ++k) {
    instance_ = waiting_[k].instance;
    std::function<void()> const handler = std::move(waiting_[k].handler); // may add others
    handler();
  }
  waiting_.clear();
  instance_.reset();
  uses_of_views();
}

void Collector::report(DiagnosticId id, SourceLocation location, std::string message, std::optional<Severity> unusual) {
  Diagnostic diagnostic{id, map_.place(location), std::move(message), map_.expansions(location)};
  if (instance_) diagnostic.notes.push_back(*instance_);
  if (unusual) diagnostic.severity = *unusual;
  add_diagnostic(facts_, diagnostic);
}

void Collector::wrap(Expr const *expression, Use use, std::string detail) {
  wrap_for({}, expression, use, std::move(detail));
}

std::optional<Span> Collector::wrap_for(SourceLocation user, Expr const *expression, Use use, std::string detail) {
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

void Collector::convert(Expr const *expression, Use use, std::string type) {
  std::optional<Span> const span = wrap_for({}, expression, use, std::move(type));
  if (span && map_.is_shared(expression->getSourceRange())) facts_.shared.insert(*span);
}

std::string Collector::spelled(QualType type) const {
  while (auto const *named = type->getAs<TypedefType>()) {
    if (named->getDecl()->getDeclContext()->getRedeclContext()->isTranslationUnit()) break;
    type = named->desugar();
  }
  PrintingPolicy policy(map_.language());
  policy.Bool = true; // C's _Bool is compiled as C++ where it matters
  return with_real(type.getUnqualifiedType().getAsString(policy));
}

bool Collector::is_plain_double(Expr const *expression) const {
  return Reals::is_double(expression->getType()) && !expression->isTypeDependent() && reals_.stays_double(expression);
}

void Collector::name(llvm::StringRef name, SourceLocation begin, SourceLocation end) {
  if (name.empty() || begin.isMacroID() || end.isMacroID() || !map_.in_roots(begin)) return;
  NamedStatement statement{map_.place(begin), map_.place(end), name.str()};
  facts_.names.try_emplace(to_string(statement.begin), std::move(statement));
}

void Collector::named_variable(VarDecl const *variable) {
  Expr const *value = variable->getInit();
  if (!value || !variable->getIdentifier() || !Reals::is_double(variable->getType())) return;
  if (!variable->isFileVarDecl()) name(variable->getName(), value->getBeginLoc(), value->getEndLoc());
}

void Collector::named_target(BinaryOperator const *assignment) {
  if (assignment->isAssignmentOp() && Reals::is_double(assignment->getLHS()->getType()))
    name(name_of(assignment->getLHS()), assignment->getBeginLoc(), assignment->getEndLoc());
}

} // namespace symreal::rewrite
