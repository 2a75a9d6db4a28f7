// Wrappers: files that substitute generated code for a kernel's function, so that the user changes one file of the
// build. They pack the arguments, call the generated code and unpack the results; if a guard fails or a baked-in value
// differs, they call the original.
//
//   a file of its own   defines the function; its object replaces the original's, which is called under another name
//   a copy              of the function's file, with generated code before the body, which stays; for functions that
//                       no other file can define
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "program/record/front.h"
#include "tool/output/outputs.h"

#include <vector>

namespace symreal::tool {

// Wrappers of the kernels of one run. Each is compiled under its source's flags before it is returned. Throws
// no_wrapper.
class Wrappers {
public:
  explicit Wrappers(program::Front const &front) : front_(front) {}

  // For `generated` = "arm.c": the file arm_wrapper.c of a C function, arm_wrapper.cpp of a C++ one. Empty if a copy is
  // needed.
  std::vector<OutputFile> add(program::Recorded const &recorded, Graph const &graph, EmitterOptions const &options,
                              std::string const &generated);
  // Copies: arm_wrapper.c, or the directory arm_wrapper for a function in a header. `remarks`: instructions for use.
  std::vector<OutputFile> copies(std::vector<Diagnostic> &remarks) const;

private:
  // Text inserted into a copy for one function.
  struct Inserted {
    rewrite::Kernel kernel;
    std::string wrapper; // path of the copy, without extension
    std::string why;
    bool with_classes;
    std::vector<std::string> blocks; // blocks before the text of the file
    std::string statements;          // statements before the function's body
  };
  std::vector<OutputFile> copies_for(Inserted const &inserted, std::vector<Diagnostic> &remarks) const;

  program::Front const &front_;
  std::vector<Inserted> inserted_;
};

} // namespace symreal::tool
