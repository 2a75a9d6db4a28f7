#include "rewrite/instrument/record_function.h"

#include "rewrite/instrument/record_call.h"

#include <llvm/IR/InstIterator.h>

namespace symreal::oracle {

using llvm::Instruction;
using llvm::IRBuilder;
using llvm::Value;

namespace {

std::optional<Op> operation_of(Instruction const &instruction) {
  switch (instruction.getOpcode()) {
  case Instruction::FAdd: return Op::add;
  case Instruction::FSub: return Op::sub;
  case Instruction::FMul: return Op::mul;
  case Instruction::FDiv: return Op::div;
  case Instruction::FRem: return Op::fmod;
  case Instruction::FNeg: return Op::neg;
  default: return std::nullopt;
  }
}

class FunctionRecorder {
public:
  FunctionRecorder(Recorder const &recorder, llvm::TargetLibraryInfo const &library)
      : recorder_(recorder),
        library_(library),
        conditions_(recorder) {}

  void record(llvm::Function &function) {
    std::vector<Instruction *> instructions, selects;
    for (Instruction &one : llvm::instructions(function)) instructions.push_back(&one);
    for (Instruction *one : instructions) // selects need the conditions of all comparisons
      (llvm::isa<llvm::SelectInst, llvm::UIToFPInst>(one) ? selects.push_back(one) : record(*one));
    for (Instruction *one : selects) record_select(*one);
    conditions_.settle();
  }

private:
  void record(Instruction &one) {
    if (auto const op = operation_of(one); op && is_number(&one)) return record_operation(one, *op);
    if (auto *comparison = llvm::dyn_cast<llvm::FCmpInst>(&one); comparison && is_number(one.getOperand(0)))
      return conditions_.add(*comparison);
    if (auto *call = llvm::dyn_cast<llvm::CallInst>(&one)) return record_call(*call, recorder_, conditions_, library_);
    if (auto *cast = llvm::dyn_cast<llvm::CastInst>(&one); cast && is_number(one.getOperand(0))) record_cast(*cast);
  }

  void record_operation(Instruction &one, Op op) {
    std::vector<Value *> const operands(one.op_begin(), one.op_end());
    record_in_place(one, operands, [&](IRBuilder<> &at) { return recorder_.operation(at, op, operands); });
  }

  void record_cast(llvm::CastInst &cast) {
    bool const is_conversion = llvm::isa<llvm::FPToSIInst, llvm::FPToUIInst>(cast);
    if (!is_conversion && !llvm::isa<llvm::FPExtInst, llvm::FPTruncInst>(cast) && !looks_at_bits(cast)) return;
    hand_over(cast, 0, recorder_, is_conversion ? &Recorder::integer : &Recorder::number);
  }

  // Whether the bits are examined rather than only moved.
  static bool looks_at_bits(llvm::CastInst const &cast) {
    return llvm::any_of(cast.users(), [](llvm::User const *user) {
      return llvm::isa<llvm::BinaryOperator, llvm::ICmpInst, llvm::TruncInst>(user);
    });
  }

  // Records a select of doubles by a comparison, or a conversion of its truth to 1 or 0.
  void record_select(Instruction &one) {
    if (!is_number(&one)) return;
    Value *condition = conditions_.of(one.getOperand(0));
    if (!condition) return;
    Value *yes = llvm::ConstantFP::get(one.getType(), 1.0), *no = llvm::ConstantFP::get(one.getType(), 0.0);
    if (llvm::isa<llvm::SelectInst>(one)) yes = one.getOperand(1), no = one.getOperand(2);
    one.replaceAllUsesWith(either(
        &one, {condition}, [&](IRBuilder<> &at) { return recorder_.operation(at, Op::select, {condition, yes, no}); },
        [&](IRBuilder<> &at) {
          Value *holds = at.CreateFCmpUNE(condition, llvm::ConstantFP::get(at.getDoubleTy(), 0.0));
          return at.CreateSelect(holds, yes, no);
        }));
    one.eraseFromParent();
  }

  Recorder const &recorder_;
  llvm::TargetLibraryInfo const &library_;
  Conditions conditions_;
};

} // namespace

void record_function(llvm::Function &function, Recorder const &recorder, llvm::TargetLibraryInfo const &library) {
  // Attributes inferred before instrumentation no longer hold: the function records.
  function.setMemoryEffects(llvm::MemoryEffects::unknown());
  function.removeFnAttr(llvm::Attribute::Speculatable);
  FunctionRecorder(recorder, library).record(function);
}

} // namespace symreal::oracle
