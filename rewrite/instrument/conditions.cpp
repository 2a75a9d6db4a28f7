#include "rewrite/instrument/conditions.h"

#include <llvm/IR/PatternMatch.h>
#include <llvm/Transforms/Utils/Local.h>

namespace symreal::oracle {

using llvm::CmpInst;
using llvm::Instruction;
using llvm::IRBuilder;
using llvm::Value;

namespace {

Value *zero(IRBuilder<> &at) { return llvm::ConstantFP::get(at.getDoubleTy(), 0.0); }
Value *one(IRBuilder<> &at) { return llvm::ConstantFP::get(at.getDoubleTy(), 1.0); }
Instruction *next(IRBuilder<> &at) { return &*at.GetInsertPoint(); }
// Truth of a plain condition, which holds 0 or 1.
Value *holds(IRBuilder<> &at, Value *condition) { return at.CreateFCmpUNE(condition, zero(at)); }

// The comparison equivalent to this predicate or to its negation; none for predicates of two parts.
Op operator_of(CmpInst::Predicate predicate) {
  switch (predicate) {
  case CmpInst::FCMP_OLT:
  case CmpInst::FCMP_UGE: return Op::lt;
  case CmpInst::FCMP_OLE:
  case CmpInst::FCMP_UGT: return Op::le;
  case CmpInst::FCMP_OGT:
  case CmpInst::FCMP_ULE: return Op::gt;
  case CmpInst::FCMP_OGE:
  case CmpInst::FCMP_ULT: return Op::ge;
  case CmpInst::FCMP_OEQ: return Op::eq;
  case CmpInst::FCMP_UNE: return Op::ne;
  default: return Op::count;
  }
}

} // namespace

Value *Conditions::negation(Instruction *before, Value *x) const {
  return either(
      before, {x}, [&](IRBuilder<> &at) { return recorder_.operation(at, Op::logical_not, {x}); },
      [&](IRBuilder<> &at) { return at.CreateFSub(one(at), x); });
}

Value *Conditions::combination(Instruction *before, Op op, Value *x, Value *y) const {
  return either(
      before, {x, y}, [&](IRBuilder<> &at) { return recorder_.operation(at, op, {x, y}); },
      [&](IRBuilder<> &at) {
        bool const is_and = op == Op::logical_and;
        return at.CreateSelect(holds(at, x), is_and ? y : x, is_and ? x : y);
      });
}

Value *Conditions::of_nodes(llvm::FCmpInst const &comparison, IRBuilder<> &at) const {
  Value *x = comparison.getOperand(0), *y = comparison.getOperand(1);
  auto const compare = [&](Op op, Value *a, Value *b) { return recorder_.comparison(at, op, a, b); };
  CmpInst::Predicate const predicate = comparison.getPredicate();
  if (Op const op = operator_of(predicate); op != Op::count) {
    bool const is_negated = predicate != CmpInst::FCMP_UNE && CmpInst::isUnordered(predicate);
    return is_negated ? negation(next(at), compare(op, x, y)) : compare(op, x, y);
  }
  switch (predicate) {
  case CmpInst::FCMP_ONE:
  case CmpInst::FCMP_UEQ: {
    Value *differ = combination(next(at), Op::logical_or, compare(Op::lt, x, y), compare(Op::gt, x, y));
    return predicate == CmpInst::FCMP_ONE ? differ : negation(next(at), differ);
  }
  case CmpInst::FCMP_UNO:
  case CmpInst::FCMP_ORD: {
    auto const is_nan = [&](Value *a) { return llvm::isa<llvm::Constant>(a) ? zero(at) : compare(Op::ne, a, a); };
    Value *some = combination(next(at), Op::logical_or, is_nan(x), is_nan(y));
    return predicate == CmpInst::FCMP_UNO ? some : negation(next(at), some);
  }
  default: return predicate == CmpInst::FCMP_TRUE ? one(at) : zero(at);
  }
}

void Conditions::add(llvm::FCmpInst &comparison) {
  add(comparison,
      either(
          &comparison, {comparison.getOperand(0), comparison.getOperand(1)},
          [&](IRBuilder<> &at) { return of_nodes(comparison, at); },
          [&](IRBuilder<> &at) { return at.CreateUIToFP(at.Insert(comparison.clone()), at.getDoubleTy()); }));
}

Value *Conditions::of(Value *truth) {
  if (auto const found = known_.find(truth); found != known_.end()) return found->second;
  auto *instruction = llvm::dyn_cast<Instruction>(truth);
  Value *condition = instruction ? condition_of(*instruction) : nullptr;
  if (condition) logic_.emplace_back(instruction);
  return known_[truth] = condition;
}

// Condition of an and, or, xor, or select of truth values, at least one of them from a comparison.
Value *Conditions::condition_of(Instruction &logic) {
  using namespace llvm::PatternMatch;
  Value *x = nullptr, *y = nullptr;
  if (!logic.getType()->isIntegerTy(1)) return nullptr;
  if (match(&logic, m_Not(m_Value(x)))) {
    Value *of_x = of(x);
    return of_x ? negation(&logic, of_x) : nullptr;
  }
  bool const is_and = match(&logic, m_LogicalAnd(m_Value(x), m_Value(y)));
  if (!is_and && !match(&logic, m_LogicalOr(m_Value(x), m_Value(y)))) return nullptr;
  Value *of_x = of(x), *of_y = of(y);
  if (!of_x && !of_y) return nullptr;
  IRBuilder<> at(&logic); // now that no more blocks are split
  if (!of_x) of_x = at.CreateUIToFP(x, at.getDoubleTy());
  if (!of_y) of_y = at.CreateUIToFP(y, at.getDoubleTy());
  return combination(&logic, is_and ? Op::logical_and : Op::logical_or, of_x, of_y);
}

void Conditions::settle() {
  for (llvm::WeakTrackingVH &one : logic_)
    if (auto *instruction = llvm::dyn_cast_or_null<Instruction>(one))
      llvm::RecursivelyDeleteTriviallyDeadInstructions(instruction);
  for (auto const &[made, condition] : made_) {
    auto *truth = llvm::cast_or_null<Instruction>(static_cast<Value *>(made));
    if (!truth) continue; // only selects used it
    if (!truth->use_empty()) {
      Value *of = condition;
      truth->replaceAllUsesWith(either(
          truth, {of}, [&](IRBuilder<> &at) { return recorder_.decision(at, of); },
          [&](IRBuilder<> &at) { return holds(at, of); }));
    }
    truth->eraseFromParent();
  }
}

} // namespace symreal::oracle
