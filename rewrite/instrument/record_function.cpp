#include "rewrite/instrument/record_function.h"

#include "rewrite/instrument/conditions.h"

#include <llvm/ADT/StringMap.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>

#include <optional>

namespace symreal::oracle {

using llvm::CallInst;
using llvm::Instruction;
using llvm::IRBuilder;
using llvm::Value;

namespace {

struct Operation {
  Op op;
  unsigned arity;
};

// Operations spelled as calls; operators are instructions.
llvm::StringMap<Operation> make_functions() {
  enum Form { infix, prefix, call, cast, select, local, external };
  llvm::StringMap<Operation> functions;
#define OPERATION(id, arity, form, name, ...)                                                                          \
  if constexpr (form == call) functions.insert({name, {Op::id, arity}});
#include <symreal/operations.def>
#undef OPERATION
  functions.insert({"nearbyint", functions.lookup("rint")});
  return functions;
}

// Operation of a C library function, such as "sin".
std::optional<Operation> operation_of_function(llvm::StringRef name) {
  static llvm::StringMap<Operation> const functions = make_functions();
  auto const found = functions.find(name);
  if (found == functions.end()) return std::nullopt;
  return found->second;
}

// Operation of an intrinsic on doubles, such as "llvm.fabs.f64".
std::optional<Operation> operation_of_intrinsic(llvm::StringRef name) {
  if (!name.consume_front("llvm.") || !name.consume_back(".f64")) return std::nullopt;
  if (name == "minnum" || name == "maxnum") return operation_of_function(name == "minnum" ? "fmin" : "fmax");
  return operation_of_function(name);
}

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

// A call becomes a recorded operation where the table has it; to text and to other functions of the library goes the
// carried value, which the recorder reports where it loses something.
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
