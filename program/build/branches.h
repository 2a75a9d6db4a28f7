// Which way the branches of the original went, within the kernel: counted by clang's source coverage in one more build
// of the original, which runs the samples that are compared.
#pragma once

#include "program/build/compile.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

// A condition, or an operand of && and || in one, that is asked in a function that the kernel runs.
struct BranchCount {
  std::string place;     // in words
  std::string condition; // as the source has it
  std::string function;  // which of several made of one template, or empty
  std::uint64_t yes = 0, no = 0;
};

// Adds the counts of each to those of the same branch in `all`.
void add(std::vector<BranchCount> &all, std::vector<BranchCount> const &more);

struct BranchResult {
  std::string obstacle; // why they could not be counted, or empty
  std::vector<BranchCount> branches;
};

// How many of the directions, two of each, no sample took.
std::size_t count_unseen(std::vector<BranchCount> const &branches);

// The build that counts; or why there is none.
struct CoveredProgram {
  std::string path, obstacle;
};
CoveredProgram build_covered(BuildRequest const &request, Overlay const &rewritten, Overlay const &annotated,
                             Workspace const &workspace);

// What it has left when it ended.
struct CoveredRun {
  std::string program, profile;
  std::vector<std::uint64_t> stack; // where the kernel begins, as Replay::stack
  std::uint64_t samples = 0;        // that have run
};

// `annotated`: the texts that the program was built of.
BranchResult read_branches(CoveredRun const &run, rewrite::Result const &annotated, rewrite::Kernel const &kernel);

} // namespace symreal::program
