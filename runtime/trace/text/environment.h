// errno and the floating-point environment of a recording (<symreal/environment.h> says what is told here).
#pragma once

#include <set>
#include <string>

namespace symreal::trace {

class Environment {
public:
  static Environment &current(); // one per thread

  void begin();
  void error_read(char const *place);
  void used(char const *what, char const *place);

  // How arithmetic differs from what is promised about it: "does not round to nearest"; empty if it does not.
  static std::string unusual_modes();

private:
  std::set<std::string> reported_; // places
};

} // namespace symreal::trace
