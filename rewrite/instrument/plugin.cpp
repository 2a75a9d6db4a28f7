// clang -fpass-plugin=symreal-record-instructions.so: operations on doubles record themselves. The pass comes last, and
// changes no instruction that is executed on ordinary numbers.
#include "rewrite/instrument/record_function.h"

#include <llvm/Analysis/ValueTracking.h>
#include <llvm/Demangle/Demangle.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Module.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Passes/PassPlugin.h>
#include <llvm/Transforms/Scalar/Scalarizer.h>

#include <string>
#include <vector>

namespace symreal::oracle {

using llvm::Instruction;
using llvm::IRBuilder;
using llvm::Value;

namespace {

// "file:line:column", as the rewriter writes places; an inlined function keeps its own.
std::string place_of(Instruction const &one) {
  llvm::DILocation const *at = one.getDebugLoc();
  if (at == nullptr) return "";
  return (at->getFilename() + ":" + llvm::Twine(at->getLine()) + ":" + llvm::Twine(at->getColumn())).str();
}

// Reports a function's reads and writes to the recorder, which knows what outlives the kernel: numbers and integers
// that would be baked in, and changes left behind (symreal/state.h does so in a rewritten text). Must run before other
// passes change the function's loads and stores.
class MemoryWatch {
public:
  explicit MemoryWatch(llvm::Function &function) : function_(function), module_(*function.getParent()) {}

  void run() {
    std::vector<Instruction *> all;
    for (Instruction &one : llvm::instructions(function_)) all.push_back(&one);
    for (Instruction *one : all) watch(*one);
  }

private:
  void watch(Instruction &one) {
    if (auto *load = llvm::dyn_cast<llvm::LoadInst>(&one)) {
      // A load of a pointer needs no report: reads through it are reported.
      if (!load->getType()->isPtrOrPtrVectorTy())
        tell("symreal_reads", one, load->getPointerOperand(), load->getType());
    } else if (auto *store = llvm::dyn_cast<llvm::StoreInst>(&one)) {
      tell("symreal_writes", one, store->getPointerOperand(), store->getValueOperand()->getType());
    } else if (auto *update = llvm::dyn_cast<llvm::AtomicRMWInst>(&one)) {
      tell("symreal_writes", one, update->getPointerOperand(), update->getType());
    } else if (auto *copy = llvm::dyn_cast<llvm::MemTransferInst>(&one)) {
      tell_bytes("symreal_reads_bytes", one, copy->getRawSource(), copy->getLength());
      tell_bytes("symreal_writes_bytes", one, copy->getRawDest(), copy->getLength());
    } else if (auto *fill = llvm::dyn_cast<llvm::MemSetInst>(&one)) {
      tell_bytes("symreal_writes_bytes", one, fill->getRawDest(), fill->getLength());
    }
  }

  void tell(char const *what, Instruction &one, Value *address, llvm::Type *type) {
    llvm::TypeSize const size = module_.getDataLayout().getTypeStoreSize(type);
    if (size.isScalable()) return;
    IRBuilder<> at(&one);
    call(what, one, address, at.getInt64(size), at.getInt32(type->getScalarType()->isDoubleTy()));
  }
  void tell_bytes(char const *what, Instruction &one, Value *address, Value *length) {
    IRBuilder<> at(&one);
    call(what, one, address, at.CreateZExtOrTrunc(length, at.getInt64Ty()), nullptr);
  }

  void call(char const *what, Instruction &one, Value *address, Value *size, Value *is_number) {
    Value const *object = llvm::getUnderlyingObject(address);
    if (llvm::isa<llvm::AllocaInst>(object)) return; // the function's own
    auto const *global = llvm::dyn_cast<llvm::GlobalVariable>(object);
    if (global && (global->isConstant() || global->getName().starts_with("_ZGV"))) return;
    IRBuilder<> at(&one);
    std::vector<Value *> arguments = {address, size};
    if (is_number) arguments.push_back(is_number);
    arguments.push_back(at.CreateGlobalStringPtr(name_of(*object)));
    arguments.push_back(at.CreateGlobalStringPtr(place_of(one)));
    std::vector<llvm::Type *> types;
    for (Value const *argument : arguments) types.push_back(argument->getType());
    auto *const type = llvm::FunctionType::get(at.getVoidTy(), types, /*isVarArg=*/false);
    llvm::FunctionCallee callee = module_.getOrInsertFunction(what, type);
    llvm::cast<llvm::Function>(callee.getCallee())->setDoesNotThrow();
    at.CreateCall(callee, arguments);
  }

  static std::string name_of(Value const &object) {
    if (llvm::isa<llvm::GlobalVariable>(object)) return llvm::demangle(object.getName());
    if (!object.hasName()) return "what a pointer leads to";
    return ("*" + object.getName()).str();
  }

  llvm::Function &function_;
  llvm::Module &module_;
};

class RecordInstructions : public llvm::PassInfoMixin<RecordInstructions> {
public:
  llvm::PreservedAnalyses run(llvm::Module &module, llvm::ModuleAnalysisManager &analyses) {
    auto &of_functions = analyses.getResult<llvm::FunctionAnalysisManagerModuleProxy>(module).getManager();
    std::vector<llvm::Function *> functions;
    for (llvm::Function &function : module)
      if (!function.isDeclaration()) functions.push_back(&function);
    Recorder const recorder(module);
    for (llvm::Function *function : functions) MemoryWatch(*function).run();
    for (llvm::Function *function : functions)
      record_function(*function, recorder, of_functions.getResult<llvm::TargetLibraryAnalysis>(*function));
    return llvm::PreservedAnalyses::none();
  }
  static bool isRequired() { return true; }
};

void add_passes(llvm::PassBuilder &builder) {
  builder.registerOptimizerLastEPCallback([](llvm::ModulePassManager &passes, llvm::OptimizationLevel) {
    passes.addPass(llvm::createModuleToFunctionPassAdaptor(llvm::ScalarizerPass())); // of vectors of doubles
    passes.addPass(RecordInstructions());
  });
}

} // namespace

} // namespace symreal::oracle

extern "C" LLVM_ATTRIBUTE_WEAK llvm::PassPluginLibraryInfo llvmGetPassPluginInfo() {
  return {LLVM_PLUGIN_API_VERSION, "symreal-record-instructions", "1", symreal::oracle::add_passes};
}
