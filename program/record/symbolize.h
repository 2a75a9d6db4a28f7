// Places in the user's source: of addresses in the symbolic program, and of the nodes of a recorded graph, with the
// names that the source gives their values.
#pragma once

#include "engine/graph/graph.h"
#include "program/build/overlay.h"
#include "rewrite/rewrite.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace symreal::program {

struct Frame {
  std::string function; // demangled
  Place place;          // in the user's source, if known
  bool rewritten;       // the place is in a rewritten file
};

// Maps addresses of the symbolic program to places in the user's source, with inline frames.
class Symbolizer {
public:
  Symbolizer(std::string executable, Overlay const &overlay);
  ~Symbolizer();

  // Frames of return addresses (relative to the load base, innermost first). Omits frames without debug information,
  // including the runtime's.
  std::vector<Frame> frames(std::vector<std::uint64_t> const &return_addresses);

private:
  struct Engine;
  std::string executable_;
  Overlay const &overlay_;
  std::unique_ptr<Engine> engine_;
};

// Resolves the graph's locations to places. The innermost place in a rewritten file, where the user can act, comes
// first.
void resolve(Graph &graph, Symbolizer &symbolizer);

// Names nodes: if a statement that names its value recorded several consecutive nodes, the last one is the value. The
// places of the graph must be resolved.
void name_nodes(Graph &graph, std::vector<rewrite::NamedStatement> const &statements);

} // namespace symreal::program
