// errno and the floating-point environment of a recording (<symreal/environment.h> describes the notes).
#pragma once

#include "runtime/trace/parts/parts.h"

#include <set>
#include <string>

namespace symreal::trace {

class Environment {
public:
  explicit Environment(Pool const &pool) : pool_(pool) {}

  void begin();
  void error_read(char const *place);
  void error_written() { is_error_own_ = true; }
  void used(char const *what, char const *place);

  // Deviation of the arithmetic from its premises: "does not round to nearest"; empty without one.
  static std::string unusual_modes();

private:
  Pool const &pool_;
  bool is_error_own_ = false; // errno has been written since the kernel began
  int error_at_begin_ = 0;
  std::set<std::string> reported_; // places
};

} // namespace symreal::trace
