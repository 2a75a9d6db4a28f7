// The text form of a graph. Every stage can be dumped and read back; passes and emitters are tested from it.
//
//   symreal-graph 1
//   kernel "arm"
//   input "q[0:2]" [2] at "arm.cpp" 12 9 range -3.14 3.14 = 0.5 0.25     an object: label, extents, and optionally
//   parameter "m" = 2                                                    place, range, the values while recording
//   output "tau" [2]
//   frozen "g" at "arm.cpp" 3 1 = 9.81                                   state that is baked in
//   executed mul 36                                                      what the program did, for reports
//   %0 = input 0                                                         slots are numbered through all objects
//   %1 = parameter 0
//   %2 = sin %0
//   %3 = mul %2 10                                                       constants stand where they are used
//   result 0 %3                                                          output slot 0
//   result 1 0
//   precomputed 0 %1                                                     slot of `constants`, after pass preprocess
//
// A line may end in a comment, from ';' on. Numbers read back to the same bits.
#pragma once

#include "graph/graph.h"

#include <iosfwd>
#include <string_view>

namespace symreal {

void write_graph(std::ostream &out, Graph const &graph);

// Reads one graph and validates it; throws graph_syntax with the place of the first line that does not fit. Duplicate
// nodes are kept, so that a pass can be tested on them.
Graph read_graph(std::string_view text, std::string const &file_name);

} // namespace symreal
