// The bridges of external functions (language/bridge.h).
#pragma once

#include "engine/emit/print/emission.h"

#include <string>

namespace symreal {

// The integer type of the language for one of C; nothing if it has none.
BridgeInteger const *find_integer(BridgeSyntax const &syntax, std::string_view c);

// Of the functions that are called: what is declared, and the bridges.
std::string print_bridge_declarations(Emission const &emission);
std::string print_bridges(Emission const &emission);

// The statement that calls the bridge of a function, which has this number in the graph.
std::string bridge_call(Emission const &emission, std::size_t number, ExternalCall const &call);

} // namespace symreal
