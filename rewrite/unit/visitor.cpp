// Walk of one source's syntax tree that collects facts about the roots.
#include "rewrite/c/constructs.h"
#include "rewrite/collect/handler.h"
#include "rewrite/collect/walks.h"
#include "rewrite/model/context_walk.h"
#include "rewrite/model/surroundings.h"
#include "rewrite/pragma/configured.h"
#include "rewrite/pragma/externals.h"
#include "rewrite/pragma/function_pragmas.h"
#include "rewrite/pragma/pragma_items.h"
#include "rewrite/select/decisions.h"
#include "rewrite/unit/collect_source.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Visitor : public ContextWalk {

public:
  Visitor(Collection const &all, PragmaIndex const &index, bool children_first)
      : ContextWalk(all.map, all.reals),
        all_(all),
        index_(index),
        children_first_(children_first),
        table_(all) {}

  std::vector<FunctionDecl const *> definitions;

  bool shouldTraversePostOrder() const override { return children_first_; }
  bool TraverseDecltypeTypeLoc(DecltypeTypeLoc type) override {
    Within const unevaluated(no_state_, true);
    return Walk::TraverseDecltypeTypeLoc(type);
  }
  bool TraverseConceptExprRequirement(concepts::ExprRequirement *requirement) override {
    return meet<concepts::ExprRequirement>(requirement) && Walk::TraverseConceptExprRequirement(requirement);
  }
  bool TraverseNestedNameSpecifierLoc(NestedNameSpecifierLoc name) override {
    if (name) meet<NestedNameSpecifierLoc>(name);
    return Walk::TraverseNestedNameSpecifierLoc(name);
  }

#define MEET_NODE(SYNTAX)                                                                                              \
  bool Visit##SYNTAX(SYNTAX *node) override { return meet<SYNTAX>(node); }
#define MEET_TYPE(SYNTAX)                                                                                              \
  bool Visit##SYNTAX(SYNTAX type) override { return meet<SYNTAX>(type); }
  SYMREAL_MET_STATEMENTS(MEET_NODE)
  SYMREAL_MET_DECLARATIONS(MEET_NODE)
  SYMREAL_MET_TYPES(MEET_TYPE)
#undef MEET_NODE
#undef MEET_TYPE

  bool VisitDecl(Decl *declaration) override {
    if (auto const *function = dyn_cast<FunctionDecl>(declaration);
        function && function->doesThisDeclarationHaveABody())
      definitions.push_back(function);
    return true;
  }
  bool VisitCompoundStmt(CompoundStmt *block) override {
    for (Stmt const *statement : block->body())
      note_item(statement, all_.context, reals_, all_.scalars, index_, all_.facts);
    return true;
  }

  void finish() { table_.finish(); }

private:
  template <class Syntax> bool meet(Node<Syntax> node) {
    if constexpr (std::is_same_v<Syntax, CallExpr>)
      if (!map_.in_roots(node->getBeginLoc())) return true;
    if constexpr (std::is_same_v<Syntax, CXXConstructExpr>)
      if (!map_.in_roots(node->getLocation())) return true;
    table_.meet<Syntax>(node, ANYWHERE | (passive_ ? 0 : NUMBERS) | (passive_ || no_state_ ? 0 : RUNNING),
                        {passive_, in_template_, function_, is_template_value_});
    return true;
  }

  Collection const &all_;
  PragmaIndex const &index_;
  bool const children_first_;
  SyntaxTable table_;
};

} // namespace

void collect_tree(ASTContext &context, SourceMap const &map, PragmaIndex const &index, Request const &request,
                  Facts &facts) {
  Reals reals(map);
  collect_externals(context, map, index, facts, reals);
  collect_symbolic_ints(context, map, facts, reals);
  ScalarState const scalars(context, map);
  Surroundings const surroundings(context, map, reals, scalars, facts);
  Collection const all{context, map, reals, scalars, surroundings, facts};
  Visitor visitor(all, index, request.children_first);
  visitor.TraverseDecl(context.getTranslationUnitDecl());
  visitor.finish();
  collect_instances(all);
  collect_operand_order(context, map, reals, facts);
  collect_layouts(context, map, reals, facts);
  attach_function_pragmas(visitor.definitions, map, reals, scalars, index, facts);
  attach_configured_kernels(request, visitor.definitions, map, reals, scalars, facts);
  note_statics(context, map, scalars, facts);
  collect_c_declarations(context, map, facts);
  collect_c_jumps(context, map, facts);
  collect_c_generic(context, map, facts);
  collect_c_specifiers(context, map, facts);
  collect_c_arrays(context, map, facts);
  collect_c_literals(context, map, facts);
  collect_c_names(context, map, facts);
  collect_anonymous_structs(context, map, reals, facts);
  collect_decisions(context, map, reals, index, facts);
  collect_boundaries(context, visitor.definitions, map, reals, facts);
  collect_links(context, visitor.definitions, map, facts);
}

} // namespace symreal::rewrite
