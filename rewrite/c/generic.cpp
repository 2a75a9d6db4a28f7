#include "rewrite/c/generic.h"

#include "rewrite/c/walk.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Selections : public CWalk {
public:
  using CWalk::CWalk;

  bool VisitGenericSelectionExpr(GenericSelectionExpr *selection) override {
    if (!map_.in_roots(selection->getBeginLoc())) return true;
    bool known = selection->isExprPredicate();
    for (auto const association : selection->associations()) {
      TypeSourceInfo const *type = association.getTypeSourceInfo();
      SourceLocation const end = type ? type->getTypeLoc().getEndLoc() : selection->getDefaultLoc();
      if (!type && is_replaced(end)) continue;
      known = known && replace_colon(end) && (type || replace(end, "default", "::symreal::SymrealOtherwise"));
    }
    for (Expr const *chosen : selection->getAssocExprs())
      if (chosen->getType()->isVoidPointerType() &&
          chosen->isNullPointerConstant(context_, Expr::NPC_NeverValueDependent))
        null(*chosen);
    if (!known) report(selection->getBeginLoc(), "macros make parts of this _Generic");
    return true;
  }

private:
  bool is_replaced(SourceLocation at) const {
    auto const [file, offset] = sources_.getDecomposedSpellingLoc(at);
    return sources_.getBufferData(file).substr(0, offset).ends_with("REAL_EITHER((");
  }

  // A type may be spelled by a macro, such as REAL: the colon stands behind that.
  bool replace_colon(SourceLocation end) {
    while (true) {
      std::optional<Token> const colon =
          Lexer::findNextToken(sources_.getSpellingLoc(end), sources_, context_.getLangOpts());
      if (colon && colon->is(tok::colon)) return replace(colon->getLocation(), ":", ",");
      // Already rewritten.
      if (colon && colon->is(tok::raw_identifier) && colon->getRawIdentifier().ends_with("REAL_EITHER")) return true;
      if (end.isFileID()) return false;
      end = sources_.isMacroArgExpansion(end) ? sources_.getImmediateSpellingLoc(end)
                                              : sources_.getImmediateExpansionRange(end).getEnd();
    }
  }

  // NULL converts to any pointer there; in C++ only by its own name, and not as the value of an expression.
  void null(Expr const &pointer) {
    SourceLocation at = pointer.getBeginLoc();
    if (at.isMacroID()) at = sources_.getImmediateExpansionRange(at).getBegin(); // the name
    if (!is_replaced(at)) replace(at, "NULL", "nullptr");
  }

  bool replace(SourceLocation at, llvm::StringRef spelling, std::string words) {
    std::optional<Span> const token = map_.token(at, spelling);
    if (token) facts_.wraps.insert({*token, Use::instead, std::move(words)});
    return token.has_value();
  }
};

} // namespace

void collect_c_generic(ASTContext &context, SourceMap const &map, Facts &facts) {
  if (!map.language().CPlusPlus) Selections(context, map, facts).TraverseDecl(context.getTranslationUnitDecl());
}

} // namespace symreal::rewrite
