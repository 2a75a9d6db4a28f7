#include "rewrite/c/constructs.h"
#include "rewrite/c/walk.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Literals : public CWalk {
public:
  using CWalk::CWalk;

  bool TraverseFunctionDecl(FunctionDecl *function) override {
    std::uint64_t const outer = bytes_;
    bytes_ = 0;
    bool const more = CWalk::TraverseFunctionDecl(function);
    if (bytes_ > 0 && !insert(map_.token(function->getBody()->getBeginLoc()), Use::behind,
                              "::symreal::SymrealCompoundLiterals<" + std::to_string(bytes_) + "> symreal_literals;"))
      report(function->getLocation(), "a macro makes the body of a function with compound literals");
    bytes_ = outer;
    return more;
  }
  bool TraverseUnaryExprOrTypeTraitExpr(UnaryExprOrTypeTraitExpr *) override { return true; }

  // One whose value alone is used is a value in C++ as well.
  bool VisitImplicitCastExpr(ImplicitCastExpr *cast) override {
    if (cast->getCastKind() != CK_LValueToRValue) return true;
    Expr const *object = cast->getSubExpr()->IgnoreParens();
    while (auto const *member = dyn_cast<MemberExpr>(object)) {
      if (member->isArrow()) return true;
      object = member->getBase()->IgnoreParens();
    }
    if (auto const *literal = dyn_cast<CompoundLiteralExpr>(object)) values_.insert(literal);
    return true;
  }
  bool VisitCompoundLiteralExpr(CompoundLiteralExpr *literal) override {
    if (values_.contains(literal)) return true;
    constexpr unsigned alignment = 16;
    auto const size = static_cast<std::uint64_t>(context_.getTypeSizeInChars(literal->getType()).getQuantity());
    if (!literal->isFileScope()) bytes_ += (size + alignment - 1) / alignment * alignment;
    SourceLocation const begin = literal->getLParenLoc();
    if (map_.is_argument_of(begin, "REAL_COMPOUND")) return true;
    FileID const frame = map_.frame(begin);
    std::optional<Span> const whole = map_.range_in(frame, literal->getSourceRange());
    std::optional<Span> const list = map_.range_in(frame, literal->getInitializer()->getSourceRange());
    if (!whole || !list || context_.getTypeAlign(literal->getType()) > alignment * 8)
      report(begin, "a compound literal is spelled in parts by macros, or is aligned beyond 16 bytes");
    else {
      facts_.wraps.insert({*whole, Use::compound, ""});
      facts_.wraps.insert({*list, Use::compound_list, ""});
      say_bound(*literal);
    }
    return true;
  }

private:
  // The C++ for it counts elements; characters in quotes and designated elements it does not.
  void say_bound(CompoundLiteralExpr const &literal) {
    auto const array = literal.getTypeSourceInfo()->getTypeLoc().getAs<IncompleteArrayTypeLoc>();
    auto const *list = dyn_cast<InitListExpr>(literal.getInitializer());
    if (!array || !list) return;
    InitListExpr const *syntactic =
        list->isSemanticForm() && list->getSyntacticForm() ? list->getSyntacticForm() : list;
    bool const is_counted = std::none_of(syntactic->begin(), syntactic->end(), [&](Stmt const *one) {
      return isa<DesignatedInitExpr>(one) || (isa<StringLiteral>(one) && array.getElementLoc().getType()->isCharType());
    });
    auto const *whole = context_.getAsConstantArrayType(literal.getType());
    if (!is_counted && whole &&
        !insert(map_.token(array.getLBracketLoc()), Use::behind, std::to_string(whole->getZExtSize())))
      report(literal.getLParenLoc(), "a macro makes the type of a compound literal");
  }

  llvm::SmallPtrSet<CompoundLiteralExpr const *, 8> values_;
  std::uint64_t bytes_ = 0; // of those in this function
};

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
  bool is_replaced(SourceLocation at) const { return map_.text_before(at).ends_with("REAL_EITHER(("); }

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

void collect_c_literals(ASTContext &context, SourceMap const &map, Facts &facts) {
  if (!map.language().CPlusPlus) Literals(context, map, facts).TraverseDecl(context.getTranslationUnitDecl());
}

void collect_c_generic(ASTContext &context, SourceMap const &map, Facts &facts) {
  if (!map.language().CPlusPlus) Selections(context, map, facts).TraverseDecl(context.getTranslationUnitDecl());
}

} // namespace symreal::rewrite
