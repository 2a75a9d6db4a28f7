#include "tool/frozen.h"

#include "graph/frozen.h"

namespace symreal::tool {

bool report_frozen(std::vector<program::Recorded> const &kernels, std::string const &policy, Console &console) {
  if (policy == "allow") return true;
  Severity const severity = policy == "warn" ? Severity::warning : Severity::error;
  bool any = false;
  for (program::Recorded const &recorded : kernels)
    for (std::size_t i = 0; i < recorded.graph.frozen.size(); ++i) {
      Frozen const &state = recorded.graph.frozen[i];
      if (state.is_around && policy == "state") continue; // the table and the header list it
      any = true;
      console.report({DiagnosticId::frozen_state, severity, state.place, frozen_message(recorded.kernel.name, state),
                      i < recorded.frozen_reads.size() ? recorded.frozen_reads[i] : std::vector<Note>()});
    }
  return !any || severity != Severity::error;
}

} // namespace symreal::tool
