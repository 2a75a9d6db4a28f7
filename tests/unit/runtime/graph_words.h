// A graph in messages of tests.
#pragma once

#include "engine/graph/graph_text.h"

#include <sstream>
#include <string>

namespace symreal::test {

inline std::string text(Graph const &graph) {
  std::ostringstream out;
  write_graph(out, graph);
  return out.str();
}

} // namespace symreal::test
