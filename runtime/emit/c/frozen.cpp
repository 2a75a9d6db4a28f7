// What generated code says of the state that is baked into it.
#include "graph/frozen.h"
#include "emit/c/parts.h"

#include <fmt/format.h>

namespace symreal {

std::string c_frozen_list(Graph const &graph) {
  if (graph.frozen.empty()) return {};
  std::string out = "/* Baked in with the values that the program had there when this was recorded:\n";
  for (Frozen const &state : graph.frozen)
    out += fmt::format("     {}\n", in_comment(fmt::format("{} = {} ({})", state.name, value_list(state.values),
                                                           portable_place(state.place))));
  return out + "*/\n\n";
}

} // namespace symreal
