// Symbolic values among the operands of an instruction of code that was not rewritten.
#pragma once

#include <cstdint>
#include <string>

namespace symreal::trace {

class Leak {
public:
  // Whether these bits are a node of this recording.
  bool meet(std::uint64_t bits);
  bool is_any() const { return is_torn_ || is_stale_ || !values_.empty(); }
  // If there are any. The place is where the program stands; `delayed`: as in interrupted_stack.
  void report(std::uintptr_t instruction, std::uintptr_t delayed = 0) const;

  // The bits of the carried value of a node that was met.
  static std::uint64_t value(std::uint64_t bits);

private:
  std::string values_;
  bool is_stale_ = false; // a node of another recording
  bool is_torn_ = false;  // a node with overwritten bytes
};

} // namespace symreal::trace
