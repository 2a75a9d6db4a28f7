#include "rewrite/c/constructs.h"
#include "rewrite/c/walk.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Arrays : public CWalk {
public:
  using CWalk::CWalk;

  // An array's initialiser has the type of the array.
  bool VisitStringLiteral(StringLiteral *literal) override {
    // The words of a static assertion have no type.
    auto const *array = literal->getType().isNull() ? nullptr : context_.getAsConstantArrayType(literal->getType());
    if (!array || array->getSize().ugt(literal->getLength())) return true;
    SourceLocation begin = literal->getBeginLoc(), end = literal->getEndLoc();
    // A macro that expands to the literal has other uses.
    if (SourceLocation first, last; begin.isMacroID() &&
                                    Lexer::isAtStartOfMacroExpansion(begin, sources_, context_.getLangOpts(), &first) &&
                                    Lexer::isAtEndOfMacroExpansion(end, sources_, context_.getLangOpts(), &last))
      begin = first, end = last;
    if (!insert(map_.range({begin, end}), Use::instead,
                elements(*literal, array->getSize().getZExtValue(), begin, end)) &&
        !is_rewritten(literal->getBeginLoc()))
      report(literal->getBeginLoc(), "a macro makes an array of characters without a zero behind them");
    return true;
  }

  bool VisitParmVarDecl(ParmVarDecl *parameter) override {
    if (!map_.in_roots(parameter->getLocation()) || is_rewritten(parameter->getBeginLoc())) return true;
    auto const array = parameter->getTypeSourceInfo()
                           ? parameter->getTypeSourceInfo()->getTypeLoc().getAs<ArrayTypeLoc>()
                           : ArrayTypeLoc();
    if (takes_variable_array(*parameter))
      give_address(*parameter);
    else if (array && says_more(array))
      leave_open(*parameter, array);
    return true;
  }

  // Declares, in the function's body, row types for its parameters of variable extents.
  bool VisitFunctionDecl(FunctionDecl *function) override {
    if (!function->doesThisDeclarationHaveABody()) return true;
    std::string words;
    for (ParmVarDecl const *parameter : function->parameters()) {
      if (!takes_variable_array(*parameter) || is_rewritten(parameter->getBeginLoc())) continue;
      TypeLoc const type = parameter->getTypeSourceInfo()->getTypeLoc();
      TypeLoc const rows = type.getAs<ArrayTypeLoc>() ? type.getAs<ArrayTypeLoc>().getElementLoc()
                                                      : type.getAs<PointerTypeLoc>().getPointeeLoc();
      words += (words.empty() ? "" : " ") + rows_of(rows, *parameter);
    }
    if (!words.empty() && !insert(map_.token(function->getBody()->getBeginLoc()), Use::behind, words))
      report(function->getLocation(), "a macro makes the body of a function that takes an array of variable extents");
    return true;
  }

  // Declares a row type behind an array with more than one variable extent.
  bool VisitDeclStmt(DeclStmt *statement) override {
    std::string words;
    for (Decl const *one : statement->decls()) {
      auto const *variable = dyn_cast<VarDecl>(one);
      ArrayType const *type = variable ? context_.getAsArrayType(variable->getType()) : nullptr;
      if (!type || !type->getElementType()->isVariablyModifiedType() || is_rewritten(variable->getLocation())) continue;
      auto const array = variable->getTypeSourceInfo()->getTypeLoc().getAs<ArrayTypeLoc>();
      std::string extents;
      for (auto inner = array; inner; inner = inner.getElementLoc().getAs<ArrayTypeLoc>())
        extents += (extents.empty() ? "[" : " * ") + extent(inner);
      SourceRange const range(variable->getLocation(), array.getEndLoc());
      if (!array || extents.find("()") != extents.npos ||
          !insert(map_.range(range), Use::instead, "symreal_" + variable->getNameAsString() + extents + "]"))
        report(variable->getLocation(), "'" + variable->getNameAsString() + "' is an array of variable extents " +
                                            "whose type has a name, is spelled by macros or changes something");
      else
        words += (words.empty() ? "" : " ") + rows_of(array.getElementLoc(), *variable);
    }
    if (!words.empty() && !insert(map_.token(statement->getEndLoc(), ";"), Use::behind, words))
      report(statement->getBeginLoc(), "a macro makes the declaration of an array of variable extents");
    return true;
  }

  bool VisitUnaryExprOrTypeTraitExpr(UnaryExprOrTypeTraitExpr *asked) override {
    if (asked->isArgumentType()) return true;
    Expr const *of = asked->getArgumentExpr()->IgnoreParens();
    ArrayType const *array = context_.getAsArrayType(of->getType());
    auto const *name = dyn_cast<DeclRefExpr>(of);
    bool const is_parameter = name && isa<ParmVarDecl>(name->getDecl()); // a pointer, in either language
    if (of->getType()->isVariablyModifiedType() && !is_parameter && (!name || !array || of_rows(array)))
      report(asked->getBeginLoc(), "the size of an array of variable extents, or of a part of one, is asked for");
    return true;
  }

private:
  static bool of_rows(ArrayType const *array) { return array->getElementType()->isVariablyModifiedType(); }

  std::string extent(ArrayTypeLoc array) const {
    Expr const *size = array.getSizeExpr();
    if (!size || size->HasSideEffects(context_)) return "()";
    std::string text;
    llvm::raw_string_ostream stream(text);
    size->printPretty(stream, nullptr, PrintingPolicy(context_.getLangOpts()));
    return "(" + text + ")";
  }

  // `rows`: the type of one.
  std::string rows_of(TypeLoc rows, VarDecl const &variable) const {
    std::string extents;
    int rank = 0;
    rows = rows.IgnoreParens();
    while (auto const array = rows.getAs<ArrayTypeLoc>()) {
      extents += ", " + extent(array);
      ++rank;
      rows = array.getElementLoc();
    }
    std::string const name = variable.getNameAsString();
    return "::symreal::SymrealVariableRows<" + printed(rows.getType()) + ", " + std::to_string(rank) + "> " + name +
           "(symreal_" + name + extents + ");";
  }

  // Whether the pointee has variable extents, which the caller must know; the parameter's own extent does not matter.
  static bool takes_variable_array(ParmVarDecl const &parameter) {
    QualType const pointee = parameter.getType()->getPointeeType();
    return !pointee.isNull() && pointee->isVariablyModifiedType();
  }
  static bool says_more(ArrayTypeLoc array) {
    ArrayType const *type = array.getTypePtr();
    return isa<VariableArrayType>(type) || type->getSizeModifier() != ArraySizeModifier::Normal ||
           type->getIndexTypeCVRQualifiers() != 0;
  }

  std::string elements(StringLiteral const &literal, std::uint64_t size, SourceLocation begin, SourceLocation end) {
    std::string list;
    bool const is_signed_char =
        context_.getBaseElementType(literal.getType())->isSignedIntegerType() && literal.getCharByteWidth() == 1;
    for (unsigned k = 0; k < size; ++k) {
      std::int64_t const unit = literal.getCodeUnit(k);
      list += (k == 0 ? "" : ", ") + std::to_string(is_signed_char ? static_cast<signed char>(unit) : unit);
    }
    bool const in_braces = next_token(end).is(tok::r_brace) && map_.text_before(begin).rtrim().ends_with("{");
    return in_braces ? list : "{" + list + "}";
  }

  void leave_open(ParmVarDecl const &parameter, ArrayTypeLoc array) {
    Expr const *extent = array.getSizeExpr();
    SourceLocation const begin = array.getLBracketLoc(), end = array.getRBracketLoc();
    std::optional<Span> const inside =
        begin.isFileID() && end.isFileID() ? map_.characters(begin.getLocWithOffset(1), end) : std::nullopt;
    if (!inside || (extent && extent->HasSideEffects(context_)))
      return report(parameter.getLocation(),
                    "'" + parameter.getNameAsString() + "' has an extent that macros spell or that changes something");
    facts_.wraps.insert({*inside, Use::instead, ""});
  }

  void give_address(ParmVarDecl const &parameter) {
    std::string const name = parameter.getName().empty() ? "" : "symreal_" + parameter.getNameAsString();
    bool const is_const = context_.getBaseElementType(parameter.getType()->getPointeeType()).isConstQualified();
    auto const array = parameter.getTypeSourceInfo()->getTypeLoc().getAs<ArrayTypeLoc>();
    bool const changes = array && array.getSizeExpr() && array.getSizeExpr()->HasSideEffects(context_);
    if (!parameter.getType()->isPointerType() || changes ||
        !insert(map_.range(parameter.getSourceRange()), Use::instead,
                std::string(is_const ? "void const *" : "void *") + name))
      report(parameter.getLocation(),
             "'" + parameter.getNameAsString() + "' has an extent that macros spell or that changes something");
  }
};

} // namespace

void collect_c_arrays(ASTContext &context, SourceMap const &map, Facts &facts) {
  if (!map.language().CPlusPlus) Arrays(context, map, facts).TraverseDecl(context.getTranslationUnitDecl());
}

} // namespace symreal::rewrite
