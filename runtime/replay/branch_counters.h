// Branch counters of a program that clang has built with -fprofile-instr-generate. Each sample runs in a fork of its
// own; the counts of all forks are summed. Other programs have no counters.
#pragma once

#include <cstddef>
#include <cstdint>

namespace symreal::replay {

class BranchCounters {
public:
  // Construct it before the first fork: earlier counts are left out.
  BranchCounters();
  // Adds this fork's counts, at its end.
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
