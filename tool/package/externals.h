// Check that a bundle is self-contained.
#pragma once

#include "engine/graph/graph.h"

namespace symreal::tool {

// Throws bad_option for a kernel that calls functions of a library.
void require_no_externals(Graph const &graph);

} // namespace symreal::tool
