// Symbolic links from rewritten files to their unrewritten neighbours.
#pragma once

#include "rewrite/rewrite.h"

#include <string>

namespace symreal::program {

// Links each neighbour of a rewritten file beside its copy, which lies at `top` followed by its real path, so that an
// #include in quotes finds it.
void link_neighbours(rewrite::Result const &rewritten, std::string const &top);

} // namespace symreal::program
