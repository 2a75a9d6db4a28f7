#include "engine/emit/print/remarks.h"

#include "engine/emit/language/words.h"
#include "engine/graph/frozen.h"

#include <fmt/format.h>

namespace symreal {

std::string frozen_remark(Emission const &emission) {
  Graph const &graph = emission.graph();
  if (graph.frozen.empty()) return {};
  std::vector<std::string> lines = {"Baked in with the values that the program had there when this was recorded:"};
  for (Frozen const &state : graph.frozen)
    lines.push_back("  " + in_comment(fmt::format("{} = {} ({})", state.name, value_list(state.values),
                                                  portable_place(state.place))));
  return comment(emission.language, lines, true) + "\n\n";
}

std::string guard_remark(Emission const &emission) {
  Graph const &graph = emission.graph();
  std::vector<std::string> lines = {"compute returns 0, or the number of the first guard that does not hold; output is "
                                    "left untouched then.",
                                    "The code is right where the original decides as it did while it was recorded:"};
  for (std::size_t k = 0; k < graph.guards.size(); ++k)
    lines.push_back(fmt::format("{:>3}  {}", k + 1, in_comment(guard_text(graph, graph.guards[k]))));
  return comment(emission.language, lines, true) + "\n";
}

} // namespace symreal
