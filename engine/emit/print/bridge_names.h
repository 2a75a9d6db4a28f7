// Names of bridges (language/bridge.h).
#pragma once

#include "engine/emit/language/language.h"

#include <string>
#include <vector>

namespace symreal {

// One name per function of the graph; empty if the language has no bridges.
std::vector<std::string> bridge_names(Graph const &graph, Language const &language);

} // namespace symreal
