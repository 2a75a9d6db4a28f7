// Generator of code that distinguishes nodes of a recording from ordinary numbers, as RealNumber does
// (symreal/real_number.h), and calls the recorder for nodes only.
#pragma once

#include <llvm/IR/IRBuilder.h>
#include <symreal/op.h>

#include <functional>

namespace symreal::oracle {

// The functions of the recorder, named as compilers name those of symreal::detail.
class Recorder {
public:
  explicit Recorder(llvm::Module &module);

  llvm::Value *operation(llvm::IRBuilder<> &at, Op op, llvm::ArrayRef<llvm::Value *> operands) const; // a node
  llvm::Value *comparison(llvm::IRBuilder<> &at, Op op, llvm::Value *x, llvm::Value *y) const;        // maybe settled
  llvm::Value *finite(llvm::IRBuilder<> &at, llvm::Value *x) const;                                   // as above
  llvm::Value *decision(llvm::IRBuilder<> &at, llvm::Value *condition) const;                         // an i1
  llvm::Value *integer(llvm::IRBuilder<> &at, llvm::Value *x) const; // the carried value, to be converted
  llvm::Value *number(llvm::IRBuilder<> &at, llvm::Value *x) const;  // the same, for other code
  llvm::Value *shown(llvm::IRBuilder<> &at, llvm::Value *x) const;   // the same, for text

private:
  llvm::FunctionCallee record_, compare_, compare_finite_, decide_, convert_to_integer_, convert_, shown_value_;
};

// An i1: whether the number is a node. False at once for a constant.
llvm::Value *is_node(llvm::IRBuilder<> &at, llvm::Value *number);

inline bool is_number(llvm::Value const *value) { return value->getType()->isDoubleTy(); }

using Make = std::function<llvm::Value *(llvm::IRBuilder<> &)>;
// Inserts before the instruction: `if_node` if one of the numbers is a node, else `otherwise`, of one type.
llvm::Value *either(llvm::Instruction *before, llvm::ArrayRef<llvm::Value *> numbers, Make const &if_node,
                    Make const &otherwise);
// Replaces a value computed from numbers by `if_node` if one of them is a node.
void record_in_place(llvm::Instruction &computed, llvm::ArrayRef<llvm::Value *> numbers, Make const &if_node);
// Replaces an operand that is a node by an ordinary number from the recorder.
using Carried = llvm::Value *(Recorder::*)(llvm::IRBuilder<> &, llvm::Value *) const;
void hand_over(llvm::Instruction &user, unsigned operand, Recorder const &recorder, Carried carried);

} // namespace symreal::oracle
