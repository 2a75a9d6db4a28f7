// How often each branch went which way, in a program that clang has built with -fprofile-instr-generate. Each sample
// runs in a fork of its own; what they count is summed here. In any other program there are no counters.
#pragma once

#include <cstddef>
#include <cstdint>

namespace symreal::replay {

class BranchCounters {
public:
  // Before the first fork: what has been counted by then is left out.
  BranchCounters();
  // In a fork, at its end.
  void add() const;
  // The sums, to the file that LLVM_PROFILE_FILE names.
  void write() const;
  bool are_there() const { return count_ != 0; }

private:
  std::uint64_t *counters_ = nullptr; // those of the program
  std::size_t count_ = 0;
  std::uint64_t *sums_ = nullptr; // in memory that all forks share
};

} // namespace symreal::replay
