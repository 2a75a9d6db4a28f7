// Printing of the bridges of external functions (language/bridge.h).
#pragma once

#include "engine/emit/print/emission.h"

#include <string>

namespace symreal {

// The language's integer type for one of C; null if it lacks one.
BridgeInteger const *find_integer(BridgeSyntax const &syntax, std::string_view c);

// Declarations of the called functions, and their bridges.
std::string print_bridge_declarations(Emission const &emission);
std::string print_bridges(Emission const &emission);

// Statement that calls the bridge of function `number` of the graph.
std::string bridge_call(Emission const &emission, std::size_t number, ExternalCall const &call);

} // namespace symreal
