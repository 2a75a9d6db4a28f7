#include "rewrite/c/constructs.h"
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
      if (!map_.text_before(token.getLocation()).ends_with("REAL_EITHER(("))
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
    bool const is_pointer = map_.text_before(declaration.getLocation()).rtrim().ends_with("*");
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

class Anonymous : public CWalk {
public:
  Anonymous(ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts)
      : CWalk(context, map, facts),
        reals_(reals) {}

  // Anonymous structures only: the unnamed field through which outer classes see one has no text.
  bool VisitRecordDecl(RecordDecl *record) override {
    for (FieldDecl const *field : record->fields()) {
      std::string const name = name_of(field);
      if (name.empty()) continue;
      SourceLocation const brace = field->getType()->getAsRecordDecl()->getBraceRange().getEnd();
      insert(map_.token(brace), Use::behind, name);
    }
    return true;
  }

  bool VisitMemberExpr(MemberExpr *member) override {
    if (!member->getMemberDecl()->getDeclName()) return true; // part of the path to the written member
    std::string names;
    for (auto const *base = dyn_cast<MemberExpr>(member->getBase()->IgnoreParenImpCasts());
         base && !base->getMemberDecl()->getDeclName();
         base = dyn_cast<MemberExpr>(base->getBase()->IgnoreParenImpCasts()))
      if (auto const *field = dyn_cast<FieldDecl>(base->getMemberDecl()))
        if (std::string const name = name_of(field); !name.empty()) names.insert(0, name + ".");
    insert_path(member->getMemberLoc(), names);
    return true;
  }

  bool VisitOffsetOfExpr(OffsetOfExpr *offset) override {
    std::string names;
    for (unsigned k = 0; k < offset->getNumComponents(); ++k) {
      OffsetOfNode const &node = offset->getComponent(k);
      if (node.getKind() != OffsetOfNode::Field) continue;
      if (std::string const name = name_of(node.getField()); !name.empty())
        names += name + ".";
      else if (node.getField()->getDeclName()) {
        insert_path(node.getEndLoc(), names);
        names.clear();
      }
    }
    return true;
  }

  // .x = 1 would need to name the structure around x, which C++ does not allow in one step.
  bool VisitDesignatedInitExpr(DesignatedInitExpr *initializer) override {
    for (DesignatedInitExpr::Designator const &designator : initializer->designators())
      if (designator.isFieldDesignator() && designator.getFieldDecl())
        if (std::string const name = around(designator.getFieldDecl()); !name.empty())
          report(designator.getFieldLoc(), "'." + designator.getFieldName()->getName().str() +
                                               "' designates a member of a structure without a name that holds REALs");
    return true;
  }

private:
  // Generated name of an anonymous structure that holds REALs; empty for all others. It is derived from the first named
  // member, which makes it unique within the class.
  std::string name_of(FieldDecl const *field) const {
    if (!field->isAnonymousStructOrUnion() || field->getType()->isUnionType()) return {};
    RecordDecl const *record = field->getType()->getAsRecordDecl();
    if (!record || !map_.in_roots(record->getLocation()) || !reals_.carries_real(field->getType())) return {};
    for (FieldDecl const *member : record->fields())
      if (member->getDeclName()) return "symreal_with_" + member->getNameAsString();
    return {};
  }
  std::string around(FieldDecl const *member) const {
    for (FieldDecl const *field : outer_fields(member->getParent()))
      if (std::string name = name_of(field); !name.empty()) return name;
    return {};
  }
  // The fields, from the inside out, in which an anonymous record stands.
  static std::vector<FieldDecl const *> outer_fields(RecordDecl const *record) {
    std::vector<FieldDecl const *> fields;
    while (record && record->isAnonymousStructOrUnion()) {
      auto const *outer = dyn_cast<RecordDecl>(record->getDeclContext());
      for (FieldDecl const *field : outer ? outer->fields() : record->fields())
        if (field->getType()->getAsRecordDecl() == record) fields.push_back(field);
      record = outer;
    }
    return fields;
  }

  void insert_path(SourceLocation name, std::string const &words) {
    if (!words.empty() && map_.in_roots(name) && !insert(map_.token(name), Use::before, words))
      report(name, "a macro makes the name of a member of a structure without a name that holds REALs");
  }

  Reals const &reals_;
};

} // namespace

void collect_c_specifiers(ASTContext &context, SourceMap const &map, Facts &facts) {
  if (!map.language().CPlusPlus) Specifiers(context, map, facts).TraverseDecl(context.getTranslationUnitDecl());
}

void collect_anonymous_structs(ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts) {
  Anonymous(context, map, reals, facts).TraverseDecl(context.getTranslationUnitDecl());
}

} // namespace symreal::rewrite
