// A network as sums of products, with parentheses multiplied out.
#pragma once

#include "engine/optimise/algebra/term.h"

namespace symreal::algebra {

// Which nodes keep an expression of their own: results, what is divided or handed to a function, and what has several
// users, unless it is small. The alternation between multiplying out and extracting is what finds structure; no single
// setting does.
struct ExpansionSettings {
  int product_size = 0; // a product of at most so many atoms is repeated in all of its users
  int sum_size = 3;     // so is a sum of at most so many terms,
  int most_uses = 4;    // if it has at most so many users
  int most_terms = 30;  // beyond which no product is multiplied out
};

// The value of an atom.
struct Expression {
  Atom atom;
  Sum terms;
};

struct Expansion {
  TermStore store;
  std::vector<Expression> expressions;        // operands before their users
  std::vector<std::pair<Atom, int>> integers; // atoms that are whole numbers
  Atom atoms = 0;                             // how many there are; the first are the nodes of the network
};
Expansion expand(Network const &network, ExpansionSettings const &settings);

} // namespace symreal::algebra
