// Derivatives as additional outputs of a kernel, requested by the program or by --differentiate.
#pragma once

#include "tool/options/options.h"

namespace symreal::tool {

struct DifferentiateOption {
  std::vector<std::string> requests;
  bool separate = false; // derivatives form a separate function

  bool is_given() const { return !requests.empty(); }
  void add_to(CLI::App &app);
  void add_separate_to(CLI::App &app);
  // The graph with its derivatives; unchanged if none are requested. Throws what differentiate throws.
  Graph applied(Graph graph, Report const &report) const;
};

} // namespace symreal::tool
