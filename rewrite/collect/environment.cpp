// errno, and the flags and modes of floating-point arithmetic: state that a kernel may read or set beside its numbers.
#include "rewrite/collect/collector.h"
#include "rewrite/model/library.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// `errno` expands to the target of a pointer that a function of the C library returns.
bool is_error_number(Expr const *expression) {
  auto const *target = dyn_cast<UnaryOperator>(expression->IgnoreParens());
  if (!target || target->getOpcode() != UO_Deref) return false;
  auto const *call = dyn_cast<CallExpr>(target->getSubExpr()->IgnoreParenImpCasts());
  FunctionDecl const *function = call ? call->getDirectCallee() : nullptr;
  if (!function || !function->getDeclName().isIdentifier()) return false;
  return library::has(function->getName(), library::ERROR_NUMBER);
}

} // namespace

// The whole expression, up to the macro of a library that makes it.
void Collector::environment(Expr const *expression, char const *what, std::string const &name) {
  SourceManager const &sources = map_.sources();
  SourceLocation begin = expression->getBeginLoc(), end = expression->getEndLoc();
  if (!map_.in_roots(begin)) return;
  while (begin.isMacroID() && !map_.token(begin)) begin = sources.getImmediateExpansionRange(begin).getBegin();
  while (end.isMacroID() && !map_.token(end)) end = sources.getImmediateExpansionRange(end).getEnd();
  std::optional<Span> const span = map_.range({begin, end});
  if (!span)
    return report(DiagnosticId::split_expression, begin,
                  "a macro makes a part of this expression: Symreal does not see " + name + " in it");
  facts_.wraps.insert({*span, Use::environment,
                       std::string(what) + ", " + in_quotes(name) + ", " + in_quotes(to_string(map_.place(begin)))});
}

void Collector::environment_of_call(CallExpr const *call) {
  FunctionDecl const *function = call->getDirectCallee();
  if (!function || !function->getDeclName().isIdentifier() || reals_.in_roots(function)) return;
  std::string const name = function->getName().str();
  if (llvm::StringRef const what = library::environment_effect(name); !what.empty())
    environment(call, "environment", name + ", which " + what.str());
}

void Collector::error_read(Expr const *value) {
  if (is_error_number(value)) environment(value->IgnoreParens(), "error_read", "errno");
}

void Collector::error_assigned(BinaryOperator const *assignment) {
  Expr const *target = assignment->getLHS();
  if (is_error_number(target))
    environment(target->IgnoreParens(), assignment->isCompoundAssignmentOp() ? "error_read" : "error_written", "errno");
}

} // namespace symreal::rewrite
