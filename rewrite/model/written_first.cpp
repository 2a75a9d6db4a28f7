#include "rewrite/model/written_first.h"

#include "rewrite/model/storage.h"
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

// The object that the expression names a part of, or whose address it is: `v`, `v.first`, `v[i]`, `&v`.
Expr const *whole(Expr const *expression) {
  for (;;) {
    expression = expression->IgnoreParens();
    if (auto const *member = dyn_cast<MemberExpr>(expression); member && !member->isArrow())
      expression = member->getBase();
    else if (auto const *element = dyn_cast<ArraySubscriptExpr>(expression))
      expression = element->getBase();
    else if (auto const *cast = dyn_cast<ImplicitCastExpr>(expression);
             cast && (cast->getCastKind() == CK_ArrayToPointerDecay || cast->getCastKind() == CK_NoOp))
      expression = cast->getSubExpr();
    else if (auto const *address = dyn_cast<UnaryOperator>(expression); address && address->getOpcode() == UO_AddrOf)
      expression = address->getSubExpr();
    else
      return expression;
  }
}
bool names_part(Expr const *expression, VarDecl const *variable) { return names(whole(expression), variable); }

// The effect on the variable of evaluating this expression itself, without its operands. `is_it`: whether an operand is
// the variable.
Does effect_of(Stmt const *statement, VarDecl const *variable, bool (*is_it)(Expr const *, VarDecl const *)) {
  if (auto const *operation = dyn_cast<BinaryOperator>(statement);
      operation && operation->isAssignmentOp() && is_it(operation->getLHS(), variable))
    return operation->isCompoundAssignmentOp() ? Does::reads : Does::writes;
  if (auto const *operation = dyn_cast<UnaryOperator>(statement);
      operation && operation->isIncrementDecrementOp() && is_it(operation->getSubExpr(), variable))
    return Does::reads;
  if (auto const *cast = dyn_cast<ImplicitCastExpr>(statement);
      cast && cast->getCastKind() == CK_LValueToRValue && is_it(cast->getSubExpr(), variable))
    return Does::reads;
  return Does::nothing;
}

// `count`: how often the statement itself has the variable as an operand.
using Effect = llvm::function_ref<Does(Stmt const *, VarDecl const *, unsigned &count)>;

// Occurrences of the variable in calls that return one of their arguments, as std::max(n, 1), which only read it.
unsigned choices_among(Expr const *expression, VarDecl const *variable) {
  auto const *call = dyn_cast<CallExpr>(spelled_expression(expression));
  FunctionDecl const *function = call ? call->getDirectCallee() : nullptr;
  if (!function || !selects_argument(function)) return 0;
  unsigned count = 0;
  for (Expr const *argument : call->arguments())
    count += names(spelled_expression(argument), variable) + choices_among(argument, variable);
  return count;
}

Does sure_effect_of(Stmt const *statement, VarDecl const *variable, unsigned &count) {
  Does const does = effect_of(statement, variable, names);
  count = does != Does::nothing;
  if (auto const *cast = dyn_cast<ImplicitCastExpr>(statement);
      does == Does::nothing && cast && cast->getCastKind() == CK_LValueToRValue)
    count = choices_among(cast->getSubExpr(), variable);
  return count > 0 && does == Does::nothing ? Does::reads : does;
}

// Effect with a part counted as the whole, and a call that takes the variable as an assignment.
Does likely_effect_of(Stmt const *statement, VarDecl const *variable, unsigned &count) {
  Does const does = effect_of(statement, variable, names_part);
  count = does != Does::nothing;
  if (does != Does::nothing) return does;
  if (auto const *call = dyn_cast<CallExpr>(statement)) {
    for (Expr const *argument : call->arguments()) count += names_part(argument, variable);
    if (auto const *method = dyn_cast<CXXMemberCallExpr>(call))
      count += names_part(method->getImplicitObjectArgument(), variable);
  }
  return count > 0 ? Does::writes : Does::nothing;
}

// Counts the variable's mentions, and those that the effects above explain. A lambda may be called later.
class Mentions : public Walk {
public:
  Mentions(VarDecl const *variable, Effect effect) : variable_(variable), effect_(effect) {}
  bool VisitDeclRefExpr(DeclRefExpr *reference) override {
    all += names(reference, variable_);
    return true;
  }
  bool VisitStmt(Stmt *statement) override {
    unsigned count = 0;
    (void)effect_(statement, variable_, count);
    known += count;
    return true;
  }
  bool VisitLambdaExpr(LambdaExpr *lambda) override {
    Mentions within(variable_, effect_);
    within.TraverseStmt(lambda->getBody());
    all += within.all;
    return true;
  }
  unsigned all = 0, known = 0;

private:
  VarDecl const *variable_;
  Effect effect_;
};

// Whether the block leaves the variable assigned; `reads_early` where it reads it before.
bool pass_through(CFGBlock const &block, VarDecl const *variable, Effect effect, bool is_assigned, bool &reads_early) {
  for (CFGElement const &element : block) {
    std::optional<CFGStmt> const statement = element.getAs<CFGStmt>();
    if (!statement) continue;
    unsigned count = 0;
    Does const does = effect(statement->getStmt(), variable, count);
    reads_early = reads_early || (does == Does::reads && !is_assigned);
    is_assigned = is_assigned || does == Does::writes;
  }
  return is_assigned;
}

// The block that is reached when this condition of a loop no longer holds; null for other blocks.
CFGBlock const *exit_of_loop(CFGBlock const &block) {
  Stmt const *loop = block.getTerminatorStmt();
  if (!loop || !isa<ForStmt, WhileStmt, CXXForRangeStmt>(loop) || block.succ_size() != 2) return nullptr;
  return *(block.succ_begin() + 1);
}

// `each_loop_runs`: a loop counts as run once at least.
bool is_written_first(VarDecl const *variable, Effect effect, bool each_loop_runs) {
  auto const *function = dyn_cast_or_null<FunctionDecl>(variable->getParentFunctionOrMethod());
  if (!function || !function->getBody() || function->isDependentContext()) return false;
  Mentions mentions(variable, effect);
  mentions.TraverseStmt(function->getBody());
  if (mentions.all != mentions.known) return false;
  CFG::BuildOptions options;
  options.AddEHEdges = true;
  options.setAllAlwaysAdd();
  std::unique_ptr<CFG> const graph = CFG::buildCFG(function, function->getBody(), &function->getASTContext(), options);
  if (!graph) return false;
  // Fixed point of `assigned` at the end of each block; unreached blocks are optimistic. Behind a loop, assignments of
  // its last iteration may count.
  std::vector<char> assigned(graph->getNumBlockIDs(), 1), behind(assigned);
  bool reads_early = false;
  for (bool is_new = true; is_new && !reads_early;) {
    is_new = false;
    for (CFGBlock const *block : *graph) {
      bool at_begin = block != &graph->getEntry(), after_turn = true;
      for (CFGBlock::AdjacentBlock const &before : block->preds()) {
        if (!before) continue;
        bool const left =
            exit_of_loop(*before) == block ? behind[before->getBlockID()] : assigned[before->getBlockID()];
        at_begin = at_begin && left;
        if (before->getLoopTarget()) after_turn = after_turn && left;
      }
      bool early = false, unused = false;
      bool const at_end = pass_through(*block, variable, effect, at_begin, early);
      bool const last = each_loop_runs ? pass_through(*block, variable, effect, after_turn, unused) : at_end;
      is_new = is_new || at_end != (assigned[block->getBlockID()] != 0) || last != (behind[block->getBlockID()] != 0);
      assigned[block->getBlockID()] = at_end;
      behind[block->getBlockID()] = last;
      reads_early = reads_early || early;
    }
  }
  return !reads_early;
}

} // namespace

bool WrittenFirst::holds(VarDecl const *variable) {
  auto const [found, is_new] = known_.try_emplace(variable->getCanonicalDecl(), false);
  if (is_new) found->second = variable->getType()->isScalarType() && is_written_first(variable, sure_effect_of, false);
  return known_.lookup(variable->getCanonicalDecl());
}

bool WrittenFirst::is_likely(VarDecl const *variable) {
  auto const [found, is_new] = likely_.try_emplace(variable->getCanonicalDecl(), false);
  if (is_new) found->second = is_written_first(variable, likely_effect_of, true);
  return likely_.lookup(variable->getCanonicalDecl());
}

} // namespace symreal::rewrite
