// Recovery from a killed rewrite, before anything else touches the tree.
#pragma once

#include "program/build/tree_edit.h"

namespace symreal::tool {

// Reports the recovery on standard error.
program::Recovery recover(std::string const &directory);

} // namespace symreal::tool
