// Text form of a graph: a dump of any stage that can be read back; the tests of passes and emitters use it.
//
//   symreal-graph 1
//   kernel "arm"
//   input "q[0:2]" [2] at "arm.cpp" 12 9 range -3.14 3.14 = 0.5 0.25     an object: label, extents, and optionally
//   parameter "m" = 2                                                    place, range, the values while recording
//   output "tau" [2]
//   frozen "g" at "arm.cpp" 3 1 = 9.81                                   state that is baked in
//   frozen "p" at "arm.cpp" 9 3 around = 2                               a local of the function around a block kernel
//   executed mul 36                                                      what the program did, for reports
//   location 0 at "arm.cpp" 12 9 at "LLT.h" 300 7                        the user's place, then those further in
//   location 1 stack 4711 815                                            unresolved: return addresses
//   table 0 "drag" [3] = 0.1 0.4 0.2                                     constants that lookups read
//   external 0 "force" pure returns number takes number input 3 output 3     a function that calls call
//   %0 = input 0                                                         slots are numbered across all objects
//   %1 = parameter 0
//   %2 = sin %0
//   %3 = mul %2 10                                                       constants are written in place
//   %4 = lt %2 %3 @0 "below"                                             recorded at location 0, called `below` there
//   result 0 %3                                                          output slot 0
//   result 1 0
//   guard 0 %4 @0 "sin(q[0]) < 10"                                       nonzero on the recorded path
//   effect %9                                                            the last of the ordered calls
//   precomputed 0 %1                                                     slot of `constants`, after pass preprocess
//
// A line may end in a comment, from ';' on. Numbers read back to the same bits.
#pragma once

#include "engine/graph/graph.h"

#include <iosfwd>
#include <string_view>

namespace symreal {

void write_graph(std::ostream &out, Graph const &graph);
// Per node, the k of its %k; no_node for a constant, which has no line.
std::vector<NodeId> line_numbers(Graph const &graph);

// Reads one graph and validates it; throws graph_syntax at the first invalid line. Duplicate nodes are kept, so that
// passes can be tested on them.
Graph read_graph(std::string_view text, std::string const &file_name);

} // namespace symreal
