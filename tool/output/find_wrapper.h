// Wrapper of a generated file: the file beside it, or the copies, that take the place of its kernel's function.
#pragma once

#include "program/record/front.h"

#include <set>
#include <string>
#include <vector>

namespace symreal::tool {

// Generated code with its kernel.
struct GeneratedKernel {
  std::string path, prefix;
  program::Recorded *recorded;
};

// The generated files that have a wrapper, and the program that tests these wrappers; both empty without any.
struct FoundWrappers {
  std::set<std::string> of;
  std::string program;
};

// Adds to the kernels what their wrappers compare. Throws foreign_file for a wrapper of another form of a kernel.
FoundWrappers find_wrappers(program::Front const &front, program::RunOptions const &run,
                            std::vector<GeneratedKernel> const &generated);

} // namespace symreal::tool
