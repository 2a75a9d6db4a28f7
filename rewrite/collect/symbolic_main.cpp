// <symreal/symbolic_main.h>: the calls that the pragmas stand for.
#include "rewrite/collect/collector.h"
#include "rewrite/model/object_layout.h"

namespace symreal::rewrite {
using namespace clang;

void Collector::symbolic_main(CallExpr const *call, FunctionDecl const *function) {
  if (!function->getDeclName().isIdentifier() || call->getNumArgs() == 0) return;
  llvm::StringRef const called = function->getName();
  if (called == "generate_code") {
    auto const *name = dyn_cast<StringLiteral>(call->getArg(0)->IgnoreParenImpCasts());
    if (!name) return;
    Place const place = map_.place(call->getBeginLoc());
    facts_.by_hand.push_back({.name = {},
                              .is_function = false,
                              .by_hand = true,
                              .place = place,
                              .output_file = name->getString().str(),
                              .signature = {},
                              .annotations = {},
                              .source = place.file});
  }
  bool const annotates = called == "input" || called == "parameter" || called == "output";
  if (annotates && call->getNumArgs() >= 2 &&
      map_.sources().getFilename(function->getLocation()).ends_with("symreal/symbolic_main.h"))
    annotated_structure(call->getArg(1));
}

// The header knows numbers and containers; a structure's layout is passed to it here.
void Collector::annotated_structure(Expr const *argument) {
  Expr const *object = argument->IgnoreParenImpCasts();
  DescribedObject const described = describe_object(object->getType(), false, context_, reals_);
  if (!described.refusal.empty())
    return report(DiagnosticId::pragma_item, object->getBeginLoc(),
                  "this object " + described.refusal + ": name the numbers that are meant");
  if (described.layout.text.empty()) return;
  std::optional<Span> const span = map_.range(argument->getSourceRange());
  if (!span)
    return report(DiagnosticId::pragma_item, object->getBeginLoc(),
                  "an object whose expression comes from a macro cannot be annotated: name it here");
  std::string types;
  for (std::string const &type : described.layout.containers) types += (types.empty() ? "" : ", ") + type;
  StringRef const text =
      Lexer::getSourceText(CharSourceRange::getTokenRange(argument->getSourceRange()), map_.sources(), map_.language());
  facts_.wraps.insert({*span, Use::instead,
                       "::symreal::symreal_laid_out<" + types + ">(\"" + described.layout.text +
                           "\", __builtin_addressof(" + text.str() + "))"});
}

} // namespace symreal::rewrite
