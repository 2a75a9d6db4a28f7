// The graph that `analyze` and `plot` read: unchanged, or after passes.
#pragma once

#include "engine/graph/graph.h"
#include "tool/options/options.h"

#include <string>

namespace symreal::tool {

void add_passes_before_analysis(CLI::App &command, PassOptions &passes);

// Throws option_without_effect for a mode of passes without passes.
Graph analyzed_graph(CLI::App const &command, PassOptions const &passes, std::string const &file);

} // namespace symreal::tool
