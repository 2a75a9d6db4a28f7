// --vector=N: computes operations side by side, as vectors of N numbers.
#pragma once

#include "engine/plan/lanes/lanes.h"
#include "tool/options/options.h"

namespace symreal::tool {

struct VectorOption {
  unsigned width = 0; // 0: not given

  bool is_given() const { return width != 0; }
  void add_to(CLI::App &app);
  // Throws bad_option, option_without_effect.
  void require_sense(EmitterOptions const &emitter, bool is_parallel, bool is_rerolled) const;
  // The vectors; nullopt if not requested or not worthwhile, with a remark why. `text`: their share of the code.
  std::optional<Laned> lanes(Schedule const &plan, std::vector<Diagnostic> &remarks, std::string &text) const;
};

} // namespace symreal::tool
