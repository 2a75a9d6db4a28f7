#include "tool/frozen.h"

#include <fmt/format.h>

namespace symreal::tool {

bool report_frozen(std::vector<program::Recorded> const &kernels, std::string const &policy, Console &console) {
  if (policy == "allow") return true;
  Severity severity = policy == "error" ? Severity::error : Severity::warning;
  bool any = false;
  for (program::Recorded const &recorded : kernels)
    for (Frozen const &state : recorded.graph.frozen) {
      any = true;
      console.report({DiagnosticId::frozen_state, severity, state.place,
                      fmt::format("kernel '{}' reads '{}', which is neither input nor parameter", recorded.kernel.name,
                                  state.name)});
    }
  return !any || severity != Severity::error;
}

} // namespace symreal::tool
