// What a killed rewrite left behind is put in order before anything else is done with the tree.
#pragma once

#include "program/build/tree_edit.h"

namespace symreal::tool {

// Says what was done on standard error.
program::Recovery recover(std::string const &directory);

} // namespace symreal::tool
