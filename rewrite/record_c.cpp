// What C allows and C++ does not, beyond what a cast can make good.
#include "rewrite/keyword_names.h"
#include "rewrite/recorder.h"

namespace symreal::rewrite {
using namespace clang;

void Recorder::c_declaration(NamedDecl const *declaration) {
  if (map_.language().CPlusPlus || !declaration->getIdentifier()) return;
  if (is_keyword_of_cpp(declaration->getName())) {
    std::optional<Span> const span = map_.token(declaration->getLocation());
    bool const stands_there = span && map_.text(*span, declaration->getLocation()) == declaration->getName();
    if (!stands_there || !is_renamed(declaration->getName()))
      report(DiagnosticId::c_source, declaration->getLocation(),
             "'" + declaration->getNameAsString() + "' is a keyword of C++");
  }
  if (auto const *variable = dyn_cast<VarDecl>(declaration))
    if (variable->isFileVarDecl() && variable->getPreviousDecl() && !variable->hasExternalStorage() &&
        variable->getPreviousDecl()->isThisDeclarationADefinition(context_) != VarDecl::DeclarationOnly)
      report(DiagnosticId::c_source, variable->getLocation(),
             "'" + variable->getNameAsString() + "' is defined a second time");
  if (auto const *function = dyn_cast<FunctionDecl>(declaration))
    if (function->isThisDeclarationADefinition() && !function->hasWrittenPrototype() && function->getNumParams() > 0)
      report(DiagnosticId::c_source, function->getLocation(),
             "'" + function->getNameAsString() + "' is defined in the style before C89");
}

void Recorder::c_call(CallExpr const *call) {
  if (map_.language().CPlusPlus || call->getNumArgs() == 0 || call->getBuiltinCallee() != 0) return;
  QualType const function = call->getCallee()->getType()->getPointeeType();
  if (!function.isNull() && function->getAs<FunctionNoProtoType>())
    report(DiagnosticId::c_source, call->getBeginLoc(),
           "a function that is declared without parameters is called with arguments");
}

// What takes a pointer to const in C++ gives one.
void Recorder::c_search(CallExpr const *call) {
  static llvm::StringSet<> const searches = {"memchr", "strchr",  "strrchr", "strstr",  "strpbrk",
                                             "wcschr", "wcsrchr", "wcsstr",  "wcspbrk", "wmemchr"};
  FunctionDecl const *function = call->getDirectCallee();
  if (map_.language().CPlusPlus || !function || reals_.in_roots(function) || !function->getIdentifier()) return;
  if (searches.contains(function->getName()) &&
      call->getArg(0)->IgnoreParenImpCasts()->getType()->getPointeeType().isConstQualified())
    wrap(call, Use::cast, call->getType().getAsString(PrintingPolicy(map_.language())));
}

} // namespace symreal::rewrite
