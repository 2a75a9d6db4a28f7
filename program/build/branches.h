// Branch coverage of the original within the kernel: counted by clang's source coverage in a separate build that runs
// the compared samples.
#pragma once

#include "program/build/compile.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

// Counts of a condition, or of an operand of && or || in one, in a function that the kernel runs.
struct BranchCount {
  std::string place;     // file and line
  std::string condition; // source text
  std::string function;  // name, if several instances of a template share the place; else empty
  std::uint64_t yes = 0, no = 0;
};

// Adds the counts in `more` to those of the same branches in `all`.
void add(std::vector<BranchCount> &all, std::vector<BranchCount> const &more);

struct BranchResult {
  std::string obstacle; // reason why branches could not be counted; else empty
  std::vector<BranchCount> branches;
};

// Number of branch directions (two for each branch) that no sample took.
std::size_t count_unseen(std::vector<BranchCount> const &branches);

// The counting build, or the obstacle to it.
struct CoveredProgram {
  std::string path, obstacle;
};
CoveredProgram build_covered(BuildRequest const &request, Overlay const &rewritten, Overlay const &annotated,
                             Workspace const &workspace);

// The profile that a run of the counting build has written.
struct CoveredRun {
  std::string program, profile;
  std::vector<std::uint64_t> stack; // call stack at the kernel's begin, as Replay::stack
  std::uint64_t samples = 0;        // number of samples that have run
};

// Reads the counts. `annotated`: the texts that the program was built from.
BranchResult read_branches(CoveredRun const &run, rewrite::Result const &annotated, rewrite::Kernel const &kernel);

} // namespace symreal::program
