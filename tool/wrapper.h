// A function with the signature of the original that packs its arguments, calls the generated code and unpacks the
// results, so that a user swaps one object file. Where a guard does not hold it calls the original under another name.
#pragma once

#include "rewrite/rewrite.h"
#include "tool/outputs.h"

namespace symreal::tool {

// For `generated` = "arm.c" of a function kernel in C the file arm_wrapper.c, in C++ arm_wrapper.cpp. Fails for a
// region kernel, which has no signature.
OutputFile wrapper_file(rewrite::Kernel const &kernel, Graph const &graph, EmitterOptions const &options,
                        std::string const &generated);

} // namespace symreal::tool
