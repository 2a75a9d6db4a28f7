#include "rewrite/model/written_first.h"

#include "rewrite/source/walk.h"

#include <clang/Analysis/CFG.h>

namespace symreal::rewrite {
using namespace clang;

namespace {

bool names(Expr const *expression, VarDecl const *variable) {
  auto const *reference = dyn_cast<DeclRefExpr>(expression->IgnoreParens());
  return reference && reference->getDecl()->getCanonicalDecl() == variable->getCanonicalDecl();
}

enum class Does { nothing, reads, writes };

// The effect on the variable of evaluating this expression itself, without its operands.
Does effect_of(Stmt const *statement, VarDecl const *variable) {
  if (auto const *operation = dyn_cast<BinaryOperator>(statement);
      operation && operation->isAssignmentOp() && names(operation->getLHS(), variable))
    return operation->isCompoundAssignmentOp() ? Does::reads : Does::writes;
  if (auto const *operation = dyn_cast<UnaryOperator>(statement);
      operation && operation->isIncrementDecrementOp() && names(operation->getSubExpr(), variable))
    return Does::reads;
  if (auto const *cast = dyn_cast<ImplicitCastExpr>(statement);
      cast && cast->getCastKind() == CK_LValueToRValue && names(cast->getSubExpr(), variable))
    return Does::reads;
  return Does::nothing;
}

// How often the variable is mentioned, and how often as an operand of the above.
class Mentions : public Walk {
public:
  explicit Mentions(VarDecl const *variable) : variable_(variable) {}
  bool VisitDeclRefExpr(DeclRefExpr *reference) override {
    all += names(reference, variable_);
    return true;
  }
  bool VisitStmt(Stmt *statement) override {
    plain += effect_of(statement, variable_) != Does::nothing;
    return true;
  }
  unsigned all = 0, plain = 0;

private:
  VarDecl const *variable_;
};

// Whether the block leaves the variable assigned; `reads_early` where it reads it before.
bool pass_through(CFGBlock const &block, VarDecl const *variable, bool is_assigned, bool &reads_early) {
  for (CFGElement const &element : block) {
    std::optional<CFGStmt> const statement = element.getAs<CFGStmt>();
    if (!statement) continue;
    Does const does = effect_of(statement->getStmt(), variable);
    reads_early = reads_early || (does == Does::reads && !is_assigned);
    is_assigned = is_assigned || does == Does::writes;
  }
  return is_assigned;
}

bool is_written_first(VarDecl const *variable) {
  auto const *function = dyn_cast_or_null<FunctionDecl>(variable->getParentFunctionOrMethod());
  if (!function || !function->getBody() || function->isDependentContext() || !variable->getType()->isScalarType())
    return false;
  Mentions mentions(variable);
  mentions.TraverseStmt(function->getBody());
  if (mentions.all != mentions.plain) return false;
  CFG::BuildOptions options;
  options.setAllAlwaysAdd();
  std::unique_ptr<CFG> const graph = CFG::buildCFG(function, function->getBody(), &function->getASTContext(), options);
  if (!graph) return false;
  // Assigned at the end of each block, until nothing changes; a block that is not reached yet is optimistic.
  std::vector<char> assigned(graph->getNumBlockIDs(), 1);
  bool reads_early = false;
  for (bool is_new = true; is_new && !reads_early;) {
    is_new = false;
    for (CFGBlock const *block : *graph) {
      bool at_begin = block != &graph->getEntry();
      for (CFGBlock::AdjacentBlock const &before : block->preds())
        if (before) at_begin = at_begin && assigned[before->getBlockID()];
      bool early = false;
      bool const at_end = pass_through(*block, variable, at_begin, early);
      is_new = is_new || at_end != (assigned[block->getBlockID()] != 0);
      assigned[block->getBlockID()] = at_end;
      reads_early = reads_early || early;
    }
  }
  return !reads_early;
}

} // namespace

bool WrittenFirst::holds(VarDecl const *variable) {
  auto const [found, is_new] = known_.try_emplace(variable->getCanonicalDecl(), false);
  if (is_new) found->second = is_written_first(variable);
  return known_.lookup(variable->getCanonicalDecl());
}

} // namespace symreal::rewrite
