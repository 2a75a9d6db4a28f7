// --reroll: repeats become loops.
#pragma once

#include "engine/plan/reroll/reroll.h"
#include "tool/options/options.h"

namespace symreal::tool {

struct RerollOption {
  bool is_given = false;

  void add_to(CLI::App &app);
  // Throws bad_option, option_without_effect.
  void require_sense(EmitterOptions const &emitter, bool is_parallel) const;
  // Nothing where it was not asked for, or there are no loops: then `remarks` says why. Otherwise `text` says how much
  // they hold. `found`: loops that were found already, if they were; then passes work on what they compute.
  std::optional<Rerolled> loops(Schedule const &plan, std::optional<Rerolled> const &found, PassOptions const &passes,
                                std::vector<Diagnostic> &remarks, std::string &text) const;
};

} // namespace symreal::tool
