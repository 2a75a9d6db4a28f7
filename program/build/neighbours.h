// What stands beside rewritten files and is left as it is.
#pragma once

#include "rewrite/rewrite.h"

#include <string>

namespace symreal::program {

// An #include in quotes looks beside its own file first. So whatever stands there gets a symbolic link beside the
// rewritten file, which lies at `top` followed by its real path.
void link_neighbours(rewrite::Result const &rewritten, std::string const &top);

} // namespace symreal::program
