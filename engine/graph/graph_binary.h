// The binary form of a graph: how a program that records or replays and the tool hand one over. It is for one version
// of Symreal on one machine; everybody else reads the text form (graph_text.h).
#pragma once

#include "engine/graph/graph.h"

#include <string>

namespace symreal {

// Throws unwritable_output.
void write_binary_graph(std::string const &path, Graph const &graph);

// Reads one graph and validates it. Throws unreadable_file, and graph_syntax where the file is of another version or
// not whole.
Graph read_binary_graph(std::string const &path);

} // namespace symreal
