// Return of a process to an earlier state: of all memory that it can write and that it shares with no other process,
// of the registers, the floating-point environment and the blocked signals. What else the system keeps for the process
// (mappings, files, signals' actions) must be as it was, but for the end of the heap.
//
// Linux with glibc on x86-64 only.
#pragma once

#include <cstddef>
#include <vector>

namespace symreal::memory {

class Rollback {
public:
  // Lists the memory. To be called after all that maps some; a fork of the process may keep and return. With more than
  // `most` bytes a fork costs less than a return.
  explicit Rollback(std::size_t most = std::size_t{1} << 21);
  // False on other systems, and in a process with more memory, or on a stack that is not its first.
  bool is_possible() const { return state_ != nullptr; }
  // Keeps the state. Returns once for that, and again after each go_back(). Its caller may have returned by then.
  void keep();
  // Returns only if the stack has grown, or the heap had before the state was kept, beyond the memory that was listed.
  void go_back();

private:
  struct State;
  struct Region {
    char *begin;
    std::size_t size, kept; // offset
  };
  static void restore(State &state);
  bool list();
  void add(char *begin, char *end);

  std::vector<Region> regions_;
  std::size_t size_ = 0;
  char *stack_ = nullptr;
  void *heap_end_ = nullptr;
  bool is_kept_ = false;
  State *state_ = nullptr; // in memory of its own, which no return changes
};

} // namespace symreal::memory
