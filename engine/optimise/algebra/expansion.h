// Expansion of a network into sums of products.
#pragma once

#include "engine/optimise/algebra/term.h"

namespace symreal::algebra {

// Nodes that keep an expression of their own: roots, operands of quotients and functions, and nodes with several users,
// unless these are small. Alternating between expansion and extraction finds structure; any single setting finds less.
struct ExpansionSettings {
  int product_size = 0; // products of at most this many atoms are duplicated into all users
  int sum_size = 3;     // so are sums of at most this many terms
  int most_uses = 4;    // and at most this many users
  int most_terms = 30;  // limit on the terms of an expanded product
};

// Definition of an atom as a sum of products.
struct Expression {
  Atom atom;
  Sum terms;
};

struct Expansion {
  TermStore store;
  std::vector<Expression> expressions;        // operands before their users
  std::vector<std::pair<Atom, int>> integers; // integer atoms
  Atom atoms = 0;                             // their number; the network's nodes come first
};
Expansion expand(Network const &network, ExpansionSettings const &settings);

} // namespace symreal::algebra
