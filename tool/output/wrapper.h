// A file that defines the function of a kernel in place of the original: it packs the arguments, calls the generated
// code and unpacks the results, so that a user swaps one object file. It includes the headers that declare the function
// and what the kernel's items name. Where a guard does not hold it calls the original under another name.
#pragma once

#include "diagnostics/diagnostic.h"
#include "rewrite/rewrite.h"
#include "tool/output/outputs.h"

#include <vector>

namespace symreal::tool {

// For `generated` = "arm.c" of a function kernel in C the file arm_wrapper.c, in C++ arm_wrapper.cpp. Fails where no
// other file can define the function; `warnings` says what it cannot include.
OutputFile wrapper_file(rewrite::Kernel const &kernel, Graph const &graph, EmitterOptions const &options,
                        std::string const &generated, std::vector<Diagnostic> &warnings);

} // namespace symreal::tool
