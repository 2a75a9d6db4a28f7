#include "rewrite/c/specifiers.h"

#include "rewrite/c/walk.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Specifiers : public CWalk {
public:
  using CWalk::CWalk;

  bool VisitVarDecl(VarDecl *variable) override {
    if (isa<ParmVarDecl>(variable) || !variable->getTypeSourceInfo()) return true;
    if (variable->getStorageClass() == SC_Auto && !variable->getType()->getContainedAutoType())
      leave_out_auto(*variable);
    add_int(*variable, variable->getTypeSourceInfo()->getTypeLoc());
    return true;
  }
  bool VisitFunctionDecl(FunctionDecl *function) override {
    FunctionTypeLoc const type = function->getFunctionTypeLoc();
    if (!type) return true;
    add_int(*function, type.getReturnLoc());
    if (TagDecl *tag = defined_in(type.getReturnLoc())) define_before(*function, *tag);
    return true;
  }

  bool VisitParmVarDecl(ParmVarDecl *parameter) override {
    return !parameter->getTypeSourceInfo() || named_before(parameter->getTypeSourceInfo()->getTypeLoc());
  }
  bool VisitUnaryExprOrTypeTraitExpr(UnaryExprOrTypeTraitExpr *asked) override {
    return !asked->isArgumentType() || named_before(asked->getArgumentTypeInfo()->getTypeLoc());
  }
  bool VisitCStyleCastExpr(CStyleCastExpr *cast) override {
    return named_before(cast->getTypeInfoAsWritten()->getTypeLoc());
  }
  bool VisitCompoundLiteralExpr(CompoundLiteralExpr *literal) override {
    return named_before(literal->getTypeSourceInfo()->getTypeLoc());
  }
  bool VisitOffsetOfExpr(OffsetOfExpr *offset) override {
    return named_before(offset->getTypeSourceInfo()->getTypeLoc());
  }

private:
  // The words before the declarator.
  static TypeLoc specifier(TypeLoc type) {
    type = without_declarator(type);
    while (auto const function = type.getAs<FunctionTypeLoc>()) type = without_declarator(function.getReturnLoc());
    return type.getUnqualifiedLoc();
  }

  // The structure or enumeration that the specifier defines; null if it only names it.
  static TagDecl *defined_in(TypeLoc type) {
    auto const named = specifier(type).getAs<ElaboratedTypeLoc>();
    TagDecl *tag = named ? named.getTypePtr()->getOwnedTagDecl() : nullptr;
    return tag && tag->isThisDeclarationADefinition() ? tag : nullptr;
  }

  bool named_before(TypeLoc type) {
    if (TagDecl const *tag = defined_in(type))
      report(tag->getLocation(), "a structure or enumeration is defined within an expression or a parameter");
    return true;
  }

  void leave_out_auto(VarDecl const &variable) {
    SourceLocation at = sources_.getSpellingLoc(variable.getBeginLoc());
    SourceLocation const name = sources_.getSpellingLoc(variable.getLocation());
    for (Token token; sources_.isBeforeInTranslationUnit(at, name); at = token.getEndLoc()) {
      if (Lexer::getRawToken(at, token, sources_, context_.getLangOpts(), /*IgnoreWhiteSpace=*/true)) break;
      if (token.isNot(tok::raw_identifier) || token.getRawIdentifier() != "auto") continue;
      auto const [file, offset] = sources_.getDecomposedLoc(token.getLocation());
      if (!sources_.getBufferData(file).substr(0, offset).ends_with("REAL_EITHER(("))
        insert(map_.token(token.getLocation()), Use::instead, "");
      return;
    }
    if (!is_rewritten(variable.getBeginLoc()))
      report(variable.getLocation(),
             "a macro makes the word 'auto' in the declaration of '" + variable.getNameAsString() + "'");
  }

  void add_int(NamedDecl const &declaration, TypeLoc type) {
    auto const built_in = specifier(type).getAs<BuiltinTypeLoc>();
    if (!built_in) return;
    SourceLocation const said = built_in.getBuiltinLoc(); // the name, if no type is written
    if (said.isValid() && said != declaration.getLocation()) return;
    if (!without_type_.insert(declaration.getBeginLoc().getRawEncoding()).second) return; // behind a comma
    std::optional<Span> const name = map_.token(declaration.getLocation(), declaration.getName());
    auto const [file, offset] = sources_.getDecomposedSpellingLoc(declaration.getLocation());
    bool const is_pointer = sources_.getBufferData(file).substr(0, offset).rtrim().ends_with("*");
    if (is_pointer || !insert(name, Use::before, "int"))
      report(declaration.getLocation(),
             "'" + declaration.getNameAsString() + "' is declared without a type, as a pointer or by a macro");
  }

  // `static struct s {...} f()` becomes `struct s {...}; static struct s f()`.
  void define_before(FunctionDecl const &function, TagDecl const &tag) {
    SourceLocation const begin = function.getBeginLoc(), keyword = tag.getOuterLocStart();
    std::string words;
    bool known = keyword.isFileID() && begin.isFileID();
    if (known && begin != keyword) {
      std::optional<Span> before = map_.characters(begin, keyword);
      known = before.has_value();
      if (known) {
        words = map_.text(*before, begin);
        while (before->end > before->begin + 1 && isWhitespace(words[before->end - before->begin - 1])) --before->end;
        facts_.wraps.insert({*before, Use::instead, ""});
      }
    }
    std::string name = tag.getNameAsString();
    SourceLocation const open = tag.getBraceRange().getBegin();
    if (name.empty()) {
      name = "symreal_of_" + function.getNameAsString();
      known = known && insert(map_.token(open), Use::before, name);
    }
    words = "; " + words + tag.getKindName().str() + " " + name;
    known = known && insert(map_.token(tag.getBraceRange().getEnd()), Use::behind, words);
    if (!known && !is_rewritten(begin) && !is_rewritten(next_token(tag.getBraceRange().getEnd()).getLocation()))
      report(tag.getLocation(),
             "macros define a structure where '" + function.getNameAsString() + "' says what it returns");
  }

  llvm::SmallSet<SourceLocation::UIntTy, 8> without_type_; // where declarations begin
};

} // namespace

void collect_c_specifiers(ASTContext &context, SourceMap const &map, Facts &facts) {
  if (!map.language().CPlusPlus) Specifiers(context, map, facts).TraverseDecl(context.getTranslationUnitDecl());
}

} // namespace symreal::rewrite
