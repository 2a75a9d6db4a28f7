// clang -fpass-plugin=symreal-record-instructions.so: operations on doubles record themselves. The pass comes last, and
// changes no instruction that is executed on ordinary numbers.
#include "rewrite/instrument/record_function.h"
#include "rewrite/instrument/watch_memory.h"

#include <llvm/IR/Module.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Passes/PassPlugin.h>
#include <llvm/Transforms/Scalar/Scalarizer.h>

namespace symreal::oracle {

namespace {

class RecordInstructions : public llvm::PassInfoMixin<RecordInstructions> {
public:
  llvm::PreservedAnalyses run(llvm::Module &module, llvm::ModuleAnalysisManager &analyses) {
    auto &of_functions = analyses.getResult<llvm::FunctionAnalysisManagerModuleProxy>(module).getManager();
    std::vector<llvm::Function *> functions;
    for (llvm::Function &function : module)
      if (!function.isDeclaration()) functions.push_back(&function);
    Recorder const recorder(module);
    for (llvm::Function *function : functions) watch_memory(*function);
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
