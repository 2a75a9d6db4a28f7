// The bridges of external functions (language/bridge.h).
#pragma once

#include "emit/print/emission.h"

#include <string>
#include <vector>

namespace symreal {

// The names of the bridges, by function of the graph.
std::vector<std::string> bridge_names(Emission const &emission);

// The integer type of the language for one of C; nothing if it has none.
BridgeInteger const *find_integer(BridgeSyntax const &syntax, std::string_view c);

// Of the functions that are called: what is declared, and the bridges.
std::string print_bridge_declarations(Emission const &emission);
std::string print_bridges(Emission const &emission);

// The statement that calls a bridge.
std::string bridge_call(Emission const &emission, ExternalCall const &call);

} // namespace symreal
