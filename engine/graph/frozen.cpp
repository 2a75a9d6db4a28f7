#include "engine/graph/frozen.h"

#include "engine/support/number.h"

#include <fmt/format.h>

namespace symreal {

std::string value_list(std::vector<double> const &values) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t i = 0; i < values.size() && i < most; ++i) text += (i ? ", " : "") + shortest(values[i]);
  return values.size() > most ? fmt::format("{}, ... ({} in all)", text, values.size()) : text;
}

std::optional<Severity> frozen_severity(Frozen const &state, std::string const &policy) {
  if (policy == "allow" || state.is_member || (state.is_around && policy == "state")) return {};
  return policy == "warn" ? Severity::warning : Severity::error;
}

std::string frozen_message(std::string const &kernel, Frozen const &state) {
  std::string const values = state.values.empty() ? "" : " (" + value_list(state.values) + ")";
  return fmt::format("kernel '{}' reads '{}'{}, which {} neither input nor parameter", kernel, state.name, values,
                     state.values.size() > 1 ? "are" : "is");
}

} // namespace symreal
