#include "rewrite/c/anonymous_structs.h"

#include "rewrite/source/walk.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Anonymous : public Walk {
public:
  Anonymous(SourceMap const &map, Reals const &reals, Facts &facts) : map_(map), reals_(reals), facts_(facts) {}

  bool TraverseDecl(Decl *declaration) override {
    bool const is_outside = declaration && !isa<TranslationUnitDecl, NamespaceDecl, LinkageSpecDecl>(declaration) &&
                            declaration->getLexicalDeclContext()->isFileContext() &&
                            !map_.in_roots(declaration->getLocation());
    return is_outside || Walk::TraverseDecl(declaration);
  }

  // Anonymous structures only: the unnamed field through which outer classes see one has no text.
  bool VisitRecordDecl(RecordDecl *record) override {
    for (FieldDecl const *field : record->fields()) {
      std::string const name = name_of(field);
      if (name.empty()) continue;
      SourceLocation const brace = field->getType()->getAsRecordDecl()->getBraceRange().getEnd();
      if (std::optional<Span> const span = map_.token(brace)) facts_.wraps.insert({*span, Use::behind, name});
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
    insert(member->getMemberLoc(), names);
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
        insert(node.getEndLoc(), names);
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

  void insert(SourceLocation name, std::string const &words) {
    if (words.empty() || !map_.in_roots(name)) return;
    if (std::optional<Span> const span = map_.token(name))
      facts_.wraps.insert({*span, Use::before, words});
    else
      report(name, "a macro makes the name of a member of a structure without a name that holds REALs");
  }
  void report(SourceLocation location, std::string message) {
    facts_.diagnostics.push_back(
        {DiagnosticId::c_source, map_.place(location), std::move(message), map_.expansions(location)});
  }

  SourceMap const &map_;
  Reals const &reals_;
  Facts &facts_;
};

} // namespace

void collect_anonymous_structs(ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts) {
  Anonymous(map, reals, facts).TraverseDecl(context.getTranslationUnitDecl());
}

} // namespace symreal::rewrite
