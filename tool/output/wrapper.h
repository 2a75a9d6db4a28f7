// Files that put generated code in the place of a kernel's function, so that the user changes one file of the build.
// They pack the arguments, call the generated code and unpack the results; where a guard does not hold, or what was
// baked in is another value, the original is called.
//
//   a file of its own   defines the function; its object takes the place of the original's, which is called under
//                       another name
//   a copy              of the function's own file, in which generated code stands before the body, which stays: for
//   what
//                       no other file can define
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "program/record/front.h"
#include "tool/output/outputs.h"

#include <vector>

namespace symreal::tool {

// Of the kernels of one run. The files are compiled, as their sources are, before they are handed out. Throws
// no_wrapper.
class Wrappers {
public:
  explicit Wrappers(program::Front const &front) : front_(front) {}

  // For `generated` = "arm.c" the file arm_wrapper.c of a function in C, arm_wrapper.cpp in C++. None where a copy is
  // needed.
  std::vector<OutputFile> add(program::Recorded const &recorded, Graph const &graph, EmitterOptions const &options,
                              std::string const &generated);
  // The copies: arm_wrapper.c, or the directory arm_wrapper for a function in a header. `remarks` says how they are
  // used.
  std::vector<OutputFile> copies(std::vector<Diagnostic> &remarks) const;

private:
  // What a copy has of a function.
  struct Inserted {
    rewrite::Kernel kernel;
    std::string wrapper; // the path of the copy, without extension
    std::string why;
    bool with_classes;
    std::vector<std::string> blocks; // before the text of the file
    std::string statements;          // before the function's body
  };
  std::vector<OutputFile> copies_for(Inserted const &inserted, std::vector<Diagnostic> &remarks) const;

  program::Front const &front_;
  std::vector<Inserted> inserted_;
};

} // namespace symreal::tool
