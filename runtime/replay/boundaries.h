// Samples at the boundaries of what a graph decides. Random samples seldom come near the point where a comparison
// changes its answer, and may never reach one side of it; mistakes like < for <= stand just there.
//
// Method: of each decision two samples with different answers are taken from those that are drawn. Where all give the
// same answer, one is moved, number by number, to where the line through two values of the margin crosses zero. Between
// the two bisection finds neighbours: the last sample with the one answer and the first with the other.
#pragma once

#include "runtime/replay/decisions.h"
#include "runtime/replay/samples.h"

namespace symreal {

struct Boundaries {
  std::vector<Sample> samples; // in pairs, one on each side
  std::size_t decisions = 0;   // that the graph has
  std::size_t crossed = 0;     // of which a boundary was found
};

// The same for the same graph and seed. The work is bounded: of a graph with many nodes fewer boundaries are looked
// for. A graph that calls functions of a program has none, since it cannot be evaluated here.
// `apart`: how far the two samples stay from each other, as a part of their first distance; 0: they are neighbours.
Boundaries find_boundaries(Graph const &graph, std::uint64_t seed, double apart = 0);

} // namespace symreal
