#include "rewrite/pragma/file_statics.h"

#include "rewrite/source/walk.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

// Of each file, once each, in the order of their definitions.
class Statics : public Walk {
public:
  Statics(ASTContext &context, SourceMap const &map) : map_(map), names_(context) {}

  bool shouldVisitTemplateInstantiations() const override { return true; }

  bool VisitVarDecl(VarDecl *variable) override {
    if (!variable->hasGlobalStorage() || variable->isThisDeclarationADefinition() == VarDecl::DeclarationOnly ||
        variable->isTemplated() || !map_.in_roots(variable->getLocation()))
      return true;
    std::optional<Span> const span = map_.token(variable->getLocation());
    if (!span) return true;
    std::string const name = names_.getName(variable);
    if (met_.insert(span->file + " " + name).second)
      by_file[span->file] += (by_file[span->file].empty() ? "" : " ") + name;
    return true;
  }

  std::map<std::string, std::string> by_file; // by real path, separated by blanks

private:
  SourceMap const &map_;
  ASTNameGenerator names_;
  std::set<std::string> met_;
};

} // namespace

void note_file_statics(ASTContext &context, SourceMap const &map, Facts &facts) {
  std::optional<Statics> statics;
  for (auto &[span, pragma] : facts.pragmas)
    for (ClauseFact &clause : pragma.clauses)
      for (ItemFact &item : clause.items) {
        if (!means_file(clause.clause, item) || !item.type.empty()) continue;
        if (!statics) statics.emplace(context, map).TraverseDecl(context.getTranslationUnitDecl());
        item.type = "file";
        item.expression = in_quotes(statics->by_file[span.file]);
      }
}

} // namespace symreal::rewrite
