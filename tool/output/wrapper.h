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

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace symreal::tool {

// Wrappers of the kernels of one run. Those that are returned have been compiled under their source's flags.
//
// Kernels of one source whose functions are replaced in a copy share it, so that one program can have all of them. If
// one of them needs a copy all are in it: a file beside a copy that has the function as well could not be linked.
class Wrappers {
public:
  explicit Wrappers(program::Front const &front) : front_(front) {}

  // For `generated` = "arm.c": the file arm_wrapper.c of a C function, arm_wrapper.cpp of a C++ one; a copy is
  // arm_wrapper.c, or the directory arm_wrapper for a function in a header. Throws no_wrapper.
  void add(program::Recorded const &recorded, Graph const &graph, EmitterOptions const &options,
           std::string const &generated);
  // Files of each kernel, in the order of the calls of `add`; copies are the files of the first kernel in them.
  // `told`: instructions for use, and as errors the kernels that have no wrapper.
  std::vector<std::vector<OutputFile>> files(std::vector<Diagnostic> &told);

private:
  // Text that takes the place of one function.
  struct Replaced {
    rewrite::Kernel kernel;
    std::string wrapper; // path of the wrapper, without extension
    std::vector<OutputFile> own;
    std::string why;              // why a copy is needed; empty: `own` is enough
    std::set<std::string> copied; // files to copy if one is needed
    // Text inserted into a copy.
    bool with_classes;
    std::vector<std::string> blocks; // blocks before the text of the file
    std::string statements;          // statements before the function's body
  };
  using Group = std::vector<std::size_t>; // of replaced_: functions in the same copies
  // Use of a group's copies.
  struct Copies {
    bool is_one_source = false;
    std::string sources;                                       // that they stand for, as the user names them
    std::vector<std::pair<std::size_t, std::string>> compiled; // copies of sources: their numbers, the sources' paths
  };
  void try_own();
  std::set<std::string> copied_for(Group const &group) const;
  std::vector<Group> groups() const;
  std::string top_of(Group const &here) const;
  std::vector<OutputFile> copies_for(Group const &group, Copies &made) const;
  std::string objection_to(Group const &group) const;
  void tell(Group const &group, Copies const &made, std::vector<OutputFile> const &files,
            std::vector<Diagnostic> &told) const;

  program::Front const &front_;
  std::vector<Replaced> replaced_;
};

} // namespace symreal::tool
