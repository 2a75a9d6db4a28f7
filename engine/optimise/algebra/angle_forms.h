// Angles as sums of others: which of the angles whose sine or cosine is taken are related.
#pragma once

#include "engine/optimise/algebra/network.h"

#include <map>

namespace symreal::algebra {

// A sum of quarters of nodes that are no such sums, in their order: q + p / 2 is {q: 4, p: 2}.
using AngleForm = std::vector<std::pair<Index, int>>;
AngleForm operator+(AngleForm const &a, AngleForm const &b);
AngleForm operator-(AngleForm const &a);

// Large multiples lose accuracy, and long sums are related to nothing.
inline constexpr int most_quarters = 4 * 8;
inline constexpr std::size_t longest_angle = 8;

AngleForm form_of(Network const &network, Index angle);
// What it is a sum of, as a new node of `network`, where the atoms have become `now`.
template <class Map> Literal made_of(AngleForm const &form, Network &network, Map const &now) {
  Literal sum = network.zero();
  for (auto const &[atom, quarters] : form)
    sum = network.sum(sum, network.product(network.constant(quarters / 4.0), now(Literal::of(atom))));
  return sum;
}

// The angles of live sines and cosines that depend on an input, those with equal forms once, and those functions.
struct Angle {
  AngleForm form;
  Index node, sine = no_index, cosine = no_index;
};
std::vector<Angle> angles_of(Network const &network);

// Whether two angles, or multiples of one, have an input in common: only then is one of use to another.
bool are_related(std::vector<Angle> const &angles, Network const &network);

} // namespace symreal::algebra
