#include "rewrite/pragma/file_statics.h"

#include "rewrite/model/storage.h"
#include "rewrite/source/walk.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

// Static variables of each file, once each, in the order of their definitions.
class Statics : public Walk {
public:
  Statics(ASTContext &context, SourceMap const &map, ScalarState const &scalars)
      : map_(map),
        scalars_(scalars),
        names_(context) {}

  bool shouldVisitTemplateInstantiations() const override { return true; }
  bool TraverseDecl(Decl *declaration) override {
    return !declaration || map_.is_outside(declaration) || Walk::TraverseDecl(declaration);
  }

  bool VisitVarDecl(VarDecl *variable) override {
    if (!variable->hasGlobalStorage() || variable->isThisDeclarationADefinition() == VarDecl::DeclarationOnly ||
        variable->isTemplated() || !map_.in_roots(variable->getLocation()))
      return true;
    std::optional<Span> const span = map_.token(variable->getLocation());
    if (!span) return true;
    std::string const name = names_.getName(variable);
    if (met_.insert(span->file + " " + name).second)
      by_file[span->file] += (by_file[span->file].empty() ? "" : " ") + name;
    if (is_changeable(variable))
      changeable.insert(name);
    else if (QualType const type = variable->getType(); type->isReferenceType() || Storage::holds_pointer(type))
      changeable.insert("*" + name);
    return true;
  }

  std::map<std::string, std::string> by_file; // by real path, separated by blanks
  std::set<std::string> changeable;           // with a star, one that only leads to what may change

private:
  bool is_changeable(VarDecl const *variable) const {
    QualType const type = variable->getType();
    bool const is_constant = variable->getASTContext().getBaseElementType(type).isConstQualified();
    if (type->isReferenceType() || type->isDependentType()) return false;
    return !is_constant && !scalars_.is_fixed(variable);
  }

  SourceMap const &map_;
  ScalarState const &scalars_;
  ASTNameGenerator names_;
  std::set<std::string> met_;
};

} // namespace

void note_statics(ASTContext &context, SourceMap const &map, ScalarState const &scalars, Facts &facts) {
  Statics statics(context, map, scalars);
  statics.TraverseDecl(context.getTranslationUnitDecl());
  facts.changeable = std::move(statics.changeable);
  for (auto &[span, pragma] : facts.pragmas)
    for (ClauseFact &clause : pragma.clauses)
      for (ItemFact &item : clause.items) {
        if (!means_file(clause.clause, item) || !item.type.empty()) continue;
        item.type = "file";
        item.expression = in_quotes(statics.by_file[span.file]);
      }
}

} // namespace symreal::rewrite
