#include "rewrite/instrument/record_call.h"

#include "rewrite/instrument/operations.h"

#include <llvm/IR/IntrinsicInst.h>

namespace symreal::oracle {

using llvm::CallInst;
using llvm::IRBuilder;
using llvm::Value;

namespace {

std::vector<Value *> arguments_of(CallInst const &call) { return {call.arg_begin(), call.arg_end()}; }

bool has_form(CallInst const &call, unsigned arity) {
  return is_number(&call) && call.arg_size() == arity && std::all_of(call.arg_begin(), call.arg_end(), is_number);
}

// Functions that are several operations: as symreal/real_math.h has them.
bool record_composed(CallInst &call, llvm::StringRef name, Recorder const &recorder) {
  std::vector<Value *> const x = arguments_of(call);
  auto const on_nodes = [&](Make const &make) { record_in_place(call, {x[0]}, make); };
  if (name == "ldexp" || name == "scalbn" || name == "llvm.ldexp.f64.i32")
    on_nodes([&](IRBuilder<> &at) {
      Value *power = at.CreateCall(call.getCalledFunction(), {llvm::ConstantFP::get(at.getDoubleTy(), 1.0), x[1]});
      return recorder.operation(at, Op::mul, {x[0], power});
    });
  else if (name == "modf")
    on_nodes([&](IRBuilder<> &at) {
      Value *whole = recorder.operation(at, Op::trunc, {x[0]});
      at.CreateStore(whole, x[1]);
      return recorder.operation(at, Op::sub, {x[0], whole});
    });
  else
    return false;
  return true;
}

// isnan, isinf, isfinite
void record_class(CallInst &call, Recorder const &recorder, Conditions &conditions) {
  auto const mask = llvm::cast<llvm::ConstantInt>(call.getArgOperand(1))->getZExtValue();
  Value *x = call.getArgOperand(0);
  auto const otherwise = [&](IRBuilder<> &at) { return at.CreateUIToFP(at.Insert(call.clone()), at.getDoubleTy()); };
  if (mask == llvm::fcNan)
    return conditions.add(
        call, either(&call, {x}, [&](IRBuilder<> &at) { return recorder.comparison(at, Op::ne, x, x); }, otherwise));
  if (mask == llvm::fcFinite)
    return conditions.add(call, either(&call, {x}, [&](IRBuilder<> &at) { return recorder.finite(at, x); }, otherwise));
  hand_over(call, 0, recorder, &Recorder::number);
}

} // namespace

void record_call(CallInst &call, Recorder const &recorder, Conditions &conditions,
                 llvm::TargetLibraryInfo const &library) {
  llvm::Function const *callee = call.getCalledFunction();
  if (call.getFunctionType()->isVarArg())
    for (unsigned k = call.getFunctionType()->getNumParams(); k < call.arg_size(); ++k)
      if (is_number(call.getArgOperand(k))) hand_over(call, k, recorder, &Recorder::shown);
  if (!callee || !callee->isDeclaration()) return;
  llvm::StringRef const name = callee->getName();
  if (callee->getIntrinsicID() == llvm::Intrinsic::is_fpclass && is_number(call.getArgOperand(0)))
    return record_class(call, recorder, conditions);
  auto const known = callee->isIntrinsic() ? operation_of_intrinsic(name) : operation_of_function(name);
  if (known && has_form(call, known->arity)) {
    std::vector<Value *> const x = arguments_of(call);
    return record_in_place(call, x, [&](IRBuilder<> &at) { return recorder.operation(at, known->op, x); });
  }
  if (call.arg_size() != 0 && is_number(call.getArgOperand(0)) && record_composed(call, name, recorder)) return;
  llvm::LibFunc function;
  if (!library.getLibFunc(*callee, function)) return;
  for (unsigned k = 0; k < call.getFunctionType()->getNumParams(); ++k)
    if (is_number(call.getArgOperand(k)))
      hand_over(call, k, recorder, call.getType()->isIntegerTy() ? &Recorder::integer : &Recorder::number);
}

} // namespace symreal::oracle
