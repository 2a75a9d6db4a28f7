// What a function reads and writes in memory is told to the recorder, which knows what outlives the kernel: numbers and
// integers that would be baked in, and what is left behind (symreal/state.h does as much in a rewritten text).
#pragma once

#include <llvm/IR/Function.h>

namespace symreal::oracle {

// Before other passes change the function's loads and stores.
void watch_memory(llvm::Function &function);

} // namespace symreal::oracle
