// Calls of the C library and of intrinsics on doubles.
#pragma once

#include "rewrite/instrument/conditions.h"

#include <llvm/Analysis/TargetLibraryInfo.h>

namespace symreal::oracle {

// A call becomes a recorded operation where the table has it; to text and to other functions of the library goes the
// carried value, which the recorder reports where it loses something.
void record_call(llvm::CallInst &call, Recorder const &recorder, Conditions &conditions,
                 llvm::TargetLibraryInfo const &library);

} // namespace symreal::oracle
