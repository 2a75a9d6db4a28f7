#include "rewrite/instrument/node_code.h"

#include <llvm/IR/Module.h>
#include <llvm/Transforms/Utils/BasicBlockUtils.h>
#include <symreal/real_number.h>

namespace symreal::oracle {

using llvm::IRBuilder;
using llvm::Value;

namespace {

llvm::FunctionCallee declare(llvm::Module &module, char const *name, llvm::Type *result,
                             llvm::ArrayRef<llvm::Type *> parameters) {
  llvm::FunctionCallee callee =
      module.getOrInsertFunction(name, llvm::FunctionType::get(result, parameters, /*isVarArg=*/false));
  auto *function = llvm::cast<llvm::Function>(callee.getCallee());
  function->setDoesNotThrow();
  if (result->isIntegerTy()) function->addRetAttr(llvm::Attribute::ZExt);
  for (unsigned k = 0; k < parameters.size(); ++k)
    if (parameters[k]->isIntegerTy()) function->addParamAttr(k, llvm::Attribute::ZExt);
  return callee;
}

Value *number_of(IRBuilder<> &at, Op op) { return at.getInt8(static_cast<std::uint8_t>(op)); }

} // namespace

Recorder::Recorder(llvm::Module &module) {
  llvm::Type *number = llvm::Type::getDoubleTy(module.getContext());
  llvm::Type *op = llvm::Type::getInt8Ty(module.getContext()), *truth = llvm::Type::getInt1Ty(module.getContext());
  auto const of_number = [&](char const *name, llvm::Type *result) { return declare(module, name, result, {number}); };
  record_ = declare(module, "_ZN7symreal6detail6recordENS_2OpENS_5types10RealNumberES3_S3_", number,
                    {op, number, number, number});
  compare_ =
      declare(module, "_ZN7symreal6detail7compareENS_2OpENS_5types10RealNumberES3_", number, {op, number, number});
  compare_finite_ = of_number("_ZN7symreal6detail14compare_finiteENS_5types10RealNumberE", number);
  decide_ = declare(module, "_ZN7symreal6detail9decide_onEm", truth, {llvm::Type::getInt64Ty(module.getContext())});
  convert_to_integer_ = of_number("_ZN7symreal6detail18convert_to_integerENS_5types10RealNumberE", number);
  convert_ = of_number("_ZN7symreal6detail7convertENS_5types10RealNumberE", number);
  shown_value_ = of_number("_ZN7symreal6detail11shown_valueENS_5types10RealNumberE", number);
}

Value *Recorder::operation(IRBuilder<> &at, Op op, llvm::ArrayRef<Value *> operands) const {
  Value *none = llvm::ConstantFP::get(at.getDoubleTy(), 0.0);
  auto const operand = [&](unsigned k) { return k < operands.size() ? operands[k] : none; };
  return at.CreateCall(record_, {number_of(at, op), operand(0), operand(1), operand(2)});
}
Value *Recorder::comparison(IRBuilder<> &at, Op op, Value *x, Value *y) const {
  return at.CreateCall(compare_, {number_of(at, op), x, y});
}
Value *Recorder::finite(IRBuilder<> &at, Value *x) const { return at.CreateCall(compare_finite_, {x}); }
Value *Recorder::decision(IRBuilder<> &at, Value *condition) const {
  return at.CreateCall(decide_, {at.CreateBitCast(condition, at.getInt64Ty())});
}
Value *Recorder::integer(IRBuilder<> &at, Value *x) const { return at.CreateCall(convert_to_integer_, {x}); }
Value *Recorder::number(IRBuilder<> &at, Value *x) const { return at.CreateCall(convert_, {x}); }
Value *Recorder::shown(IRBuilder<> &at, Value *x) const { return at.CreateCall(shown_value_, {x}); }

Value *is_node(IRBuilder<> &at, Value *number) {
  if (llvm::isa<llvm::Constant>(number)) return at.getFalse();
  Value *bits = at.CreateBitCast(number, at.getInt64Ty());
  return at.CreateICmpEQ(at.CreateLShr(bits, detail::node_shape_at), at.getInt64(detail::node_shape));
}

Value *either(llvm::Instruction *before, llvm::ArrayRef<Value *> numbers, Make const &if_node, Make const &otherwise) {
  IRBuilder<> at(before);
  Value *any = at.getFalse();
  for (Value *number : numbers) any = at.CreateOr(any, is_node(at, number));
  if (llvm::isa<llvm::Constant>(any)) return otherwise(at);
  llvm::Instruction *then = nullptr, *other = nullptr;
  llvm::SplitBlockAndInsertIfThenElse(any, before->getIterator(), &then, &other);
  auto const make = [&](llvm::Instruction *end, Make const &value) {
    IRBuilder<> within(end);
    within.SetCurrentDebugLocation(before->getDebugLoc());
    return value(within);
  };
  Value *of_node = make(then, if_node), *of_numbers = make(other, otherwise);
  at.SetInsertPoint(before);
  llvm::PHINode *result = at.CreatePHI(of_node->getType(), 2);
  result->addIncoming(of_node, then->getParent());
  result->addIncoming(of_numbers, other->getParent());
  return result;
}

void record_in_place(llvm::Instruction &computed, llvm::ArrayRef<Value *> numbers, Make const &if_node) {
  computed.replaceAllUsesWith(
      either(&computed, numbers, if_node, [&](IRBuilder<> &at) { return at.Insert(computed.clone()); }));
  computed.eraseFromParent();
}

void hand_over(llvm::Instruction &user, unsigned operand, Recorder const &recorder, Carried carried) {
  Value *x = user.getOperand(operand);
  user.setOperand(operand, either(
                               &user, {x}, [&](IRBuilder<> &at) { return (recorder.*carried)(at, x); },
                               [&](IRBuilder<> &) { return x; }));
}

} // namespace symreal::oracle
