// Instrumentation of a function's reads and writes: reports them to the recorder, which knows what outlives the kernel:
// numbers and integers that would be baked in, and changes left behind (symreal/state.h does so in a rewritten text).
#pragma once

#include <llvm/IR/Function.h>

namespace symreal::oracle {

// Must run before other passes change the function's loads and stores.
void watch_memory(llvm::Function &function);

} // namespace symreal::oracle
