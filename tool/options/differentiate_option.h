// Derivatives as further outputs of a kernel: those that the program asks for, and those of --differentiate.
#pragma once

#include "tool/options/options.h"

namespace symreal::tool {

struct DifferentiateOption {
  std::vector<std::string> requests;
  bool separate = false; // derivatives are a function of their own

  bool is_given() const { return !requests.empty(); }
  void add_to(CLI::App &app);
  void add_separate_to(CLI::App &app);
  // The graph as it is, if nobody asks for any. Throws what differentiate throws.
  Graph applied(Graph graph, Report const &report) const;
};

} // namespace symreal::tool
