// Calls of functions that are compiled elsewhere, or that read a library's state: their results are baked in like other
// state. Functions of the standard library are known (support/outside.def); `external` declares others.
#include "rewrite/collect/collector.h"

#include <clang/Tooling/Inclusions/StandardLibrary.h>

namespace symreal::rewrite {
using namespace clang;

namespace {

// Whether the function has a hook that reports its results to the recording.
bool is_watched(llvm::StringRef name) {
  static llvm::StringSet<> const names = {
#define OUTSIDE(result, symbol, name, parameters, arguments) #symbol,
#include "engine/support/outside.def"
#undef OUTSIDE
  };
  return names.contains(name);
}

bool is_standard(FunctionDecl const *function) {
  if (function->isInStdNamespace() || function->getBuiltinID() != 0) return true;
  if (!function->getDeclName().isIdentifier()) return false;
  llvm::StringRef const name = function->getName();
  using tooling::stdlib::Lang;
  using tooling::stdlib::Symbol;
  return is_watched(name) || Symbol::named("", name, Lang::C) || Symbol::named("std::", name, Lang::CXX);
}

bool has_variable(NamedVariables const &named) {
  return llvm::any_of(named.read, [](VarDecl const *variable) { return !variable->getType().isConstQualified(); });
}

} // namespace

void Collector::call_outside(CallExpr const *call) {
  FunctionDecl const *function = call->getDirectCallee();
  if (!function || call->isTypeDependent() || !map_.in_roots(call->getBeginLoc())) return;
  FunctionDecl const *pattern = Reals::pattern(function);
  if (reals_.in_roots(pattern) || reals_.external(function) || reals_.is_math(function) || is_standard(function))
    return;
  if (function->isConstexpr() || function->hasAttr<ConstAttr>() || isa<CXXOperatorCallExpr>(call)) return;
  QualType const type = call->getType();
  if (!type->isArithmeticType() || reals_.is_real(call)) return;
  bool const is_number = type->isFloatingType();
  FunctionDecl const *definition = nullptr;
  if (function->isDefined(definition)) {
    if (!is_number || !definition->getBody() || !has_variable(named_variables_.of(definition))) return;
  } else if (!is_number && map_.sources().isInSystemHeader(function->getLocation()))
    return; // a function of the system, such as open()
  environment(call, "outside", function->getQualifiedNameAsString() + "()");
}

// The format and the state of a stream that the whole program has.
void Collector::stream_asked(CXXMemberCallExpr const *call) {
  CXXMethodDecl const *method = call->getMethodDecl();
  if (!method || !method->getDeclName().isIdentifier() || !method->getParent()->isInStdNamespace() ||
      call->getNumArgs() != 0)
    return;
  constexpr llvm::StringLiteral asked[] = {"precision", "width", "flags",   "fill",       "good",  "fail",
                                           "bad",       "eof",   "rdstate", "exceptions", "gcount"};
  auto const *object = dyn_cast<DeclRefExpr>(call->getImplicitObjectArgument()->IgnoreParenImpCasts());
  auto const *variable = object ? dyn_cast<VarDecl>(object->getDecl()) : nullptr;
  if (!llvm::is_contained(asked, method->getName()) || !variable || !variable->hasGlobalStorage()) return;
  environment(call, "outside", variable->getQualifiedNameAsString() + "." + method->getName().str() + "()");
}

} // namespace symreal::rewrite
