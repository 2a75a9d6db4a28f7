#include "rewrite/select/selects.h"

#include "rewrite/select/decision_collector.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

// The functions with code that is compiled: templates as they are instantiated.
class Functions : public Walk {
public:
  explicit Functions(SourceMap const &map) : map_(map) {}
  bool shouldVisitTemplateInstantiations() const override { return true; }

  std::vector<FunctionDecl const *> found;
  std::vector<ConditionalOperator const *> choices;

  bool TraverseDecl(Decl *declaration) override {
    if (!declaration || map_.is_outside(declaration)) return true;
    return Walk::TraverseDecl(declaration);
  }
  bool VisitFunctionDecl(FunctionDecl *function) override {
    bool const is_code = function->doesThisDeclarationHaveABody() && !function->isImplicit();
    if (is_code && map_.in_roots(function->getLocation())) found.push_back(function);
    return true;
  }
  bool VisitConditionalOperator(ConditionalOperator *choice) override {
    choices.push_back(choice);
    return true;
  }

private:
  SourceMap const &map_;
};

} // namespace

void collect_decisions(ASTContext &context, SourceMap const &map, Reals const &reals, PragmaIndex const &index,
                       Facts &facts) {
  Functions functions(map);
  functions.TraverseDecl(context.getTranslationUnitDecl());
  DecisionCollector collector(context, map, reals, index, facts);
  for (FunctionDecl const *function : functions.found) collector.function(function);
  collector.check_pragmas();
  // A macro's body is one text for all of its uses.
  for (ConditionalOperator const *choice : functions.choices) collector.check_use_of_macro(choice);
}

} // namespace symreal::rewrite
