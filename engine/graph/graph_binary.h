// Binary form of a graph: the exchange format between a recording or replaying program and the tool. It is valid for
// one version of Symreal on one machine; other uses need the text form (graph_text.h).
#pragma once

#include "engine/graph/graph.h"

#include <string>

namespace symreal {

// Throws unwritable_output.
void write_binary_graph(std::string const &path, Graph const &graph);

// Reads one graph and validates it. Throws unreadable_file, or graph_syntax if the version differs or the file is
// truncated.
Graph read_binary_graph(std::string const &path);

} // namespace symreal
