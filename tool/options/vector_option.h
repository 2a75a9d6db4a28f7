// --vector=N: operations side by side as vectors of N numbers.
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
  // Nothing where it was not asked for, or nothing is worth it: then `remarks` says why. Otherwise `text` says how much
  // stands in vectors.
  std::optional<Laned> lanes(Schedule const &plan, std::vector<Diagnostic> &remarks, std::string &text) const;
};

} // namespace symreal::tool
