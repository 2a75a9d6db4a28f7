// One function, in which operations on doubles become operations that are recorded where an operand is a node.
#pragma once

#include "rewrite/instrument/node_code.h"

#include <llvm/Analysis/TargetLibraryInfo.h>

namespace symreal::oracle {

void record_function(llvm::Function &function, Recorder const &recorder, llvm::TargetLibraryInfo const &library);

} // namespace symreal::oracle
