// Conditions: truth values that come from comparisons of doubles. A select between doubles keeps its condition; any
// other use of a comparison's truth decides.
#pragma once

#include "rewrite/instrument/node_code.h"

#include <llvm/ADT/DenseMap.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/ValueHandle.h>
#include <vector>

namespace symreal::oracle {

class Conditions {
public:
  explicit Conditions(Recorder const &recorder) : recorder_(recorder) {}

  void add(llvm::FCmpInst &comparison); // of doubles
  // Adds a condition that something else computes, in place of this i1.
  void add(llvm::Instruction &truth, llvm::Value *condition) {
    made_.emplace_back(&truth, condition), known_[&truth] = condition;
  }
  // The condition as a double: a node, 0 or 1. Null if the i1 does not come from a comparison.
  llvm::Value *of(llvm::Value *truth);
  // Turns the remaining uses as an i1 into decisions.
  void settle();

private:
  llvm::Value *condition_of(llvm::Instruction &logic);
  llvm::Value *negation(llvm::Instruction *before, llvm::Value *x) const;
  llvm::Value *combination(llvm::Instruction *before, Op op, llvm::Value *x, llvm::Value *y) const;
  llvm::Value *of_nodes(llvm::FCmpInst const &comparison, llvm::IRBuilder<> &at) const;

  Recorder const &recorder_;
  std::vector<std::pair<llvm::WeakVH, llvm::Value *>> made_; // instructions
  std::vector<llvm::WeakTrackingVH> logic_;
  llvm::DenseMap<llvm::Value *, llvm::Value *> known_;
};

} // namespace symreal::oracle
