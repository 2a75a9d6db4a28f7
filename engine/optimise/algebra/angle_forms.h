// Angle forms: arguments of sines and cosines as linear combinations, which show the related ones.
#pragma once

#include "engine/optimise/algebra/network.h"

#include <map>

namespace symreal::algebra {

// A linear combination of atoms in quarters, ordered by atom: q + p / 2 is {q: 4, p: 2}.
using AngleForm = std::vector<std::pair<Index, int>>;
AngleForm operator+(AngleForm const &a, AngleForm const &b);
AngleForm operator-(AngleForm const &a);

// Limits: large multiples lose accuracy, and long sums are rarely related.
inline constexpr int most_quarters = 4 * 8;
inline constexpr std::size_t longest_angle = 8;

AngleForm form_of(Network const &network, Index angle);
// Builds the form as a node of `network`; `now` maps its atoms.
template <class Map> Literal made_of(AngleForm const &form, Network &network, Map const &now) {
  Literal sum = network.zero();
  for (auto const &[atom, quarters] : form)
    sum = network.sum(sum, network.product(network.constant(quarters / 4.0), now(Literal::of(atom))));
  return sum;
}

// Angle of live sines and cosines that depend on an input, with those functions; one per form.
struct Angle {
  AngleForm form;
  Index node, sine = no_index, cosine = no_index;
};
std::vector<Angle> angles_of(Network const &network);

// Whether two angles, or multiples of one, share an input; only then can one serve another.
bool are_related(std::vector<Angle> const &angles, Network const &network);

} // namespace symreal::algebra
