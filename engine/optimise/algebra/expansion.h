// Expansion of a network into sums of products; a term is a signed product of atoms.
#pragma once

#include "engine/optimise/algebra/network.h"

namespace symreal::algebra {

// An opaque node of a network, or a divisor that factoring extracted.
using Atom = std::uint32_t;

// Range of atoms in a term store. `hash` is a sum over them, so the hash of a common part can be subtracted.
struct Term {
  std::uint32_t first = 0;
  std::uint16_t variables = 0, constants = 0; // atoms of each kind; free nodes are constants
  int coefficient = 1;                        // 1 or -1 once integers are atoms
  std::uint64_t hash = 0;

  std::size_t size() const { return std::size_t{variables} + constants; }
  // All constants fold into one number.
  int factors() const { return variables + (constants != 0); }
  int multiplications() const { return std::max(factors() - 1, 0); }
};
using Sum = std::vector<Term>;

// Common part of two terms: the number of atoms of each kind, and their hash.
struct Common {
  int variables = 0, constants = 0;
  std::uint64_t hash = 0;
};

class TermStore {
public:
  static std::uint64_t hash_of(Atom atom) { return mixed(atom + 0x9E3779B97F4A7C15u); }

  std::span<Atom const> atoms(Term const &term) const { return {atoms_.data() + term.first, term.size()}; }
  bool is_constant(Atom atom) const { return atom < is_constant_.size() && is_constant_[atom]; }
  void set_constant(Atom atom) {
    if (is_constant_.size() <= atom) is_constant_.resize(atom + 1, 0);
    is_constant_[atom] = 1;
  }

  Term single(Atom atom) { return make(std::span(&atom, 1)); }
  Term make(std::span<Atom const> sorted) {
    Term term;
    term.first = static_cast<std::uint32_t>(atoms_.size());
    for (Atom atom : sorted) append(term, atom);
    return term;
  }
  Term product(Term const &a, Term const &b) {
    Term term;
    term.first = static_cast<std::uint32_t>(atoms_.size());
    term.coefficient = a.coefficient * b.coefficient;
    std::size_t i = a.first, j = b.first;
    std::size_t const i_end = i + a.size(), j_end = j + b.size();
    while (i < i_end || j < j_end)
      append(term, j == j_end || (i < i_end && atoms_[i] <= atoms_[j]) ? atoms_[i++] : atoms_[j++]);
    return term;
  }
  Common common(Term const &a, Term const &b) const {
    Common common;
    std::size_t i = a.first, j = b.first;
    std::size_t const i_end = i + a.size(), j_end = j + b.size();
    while (i < i_end && j < j_end) {
      if (atoms_[i] == atoms_[j]) {
        ++(is_constant(atoms_[i]) ? common.constants : common.variables);
        common.hash += hash_of(atoms_[i]);
        ++i, ++j;
      } else {
        ++(atoms_[i] < atoms_[j] ? i : j);
      }
    }
    return common;
  }

private:
  void append(Term &term, Atom atom) {
    atoms_.push_back(atom);
    ++(is_constant(atom) ? term.constants : term.variables);
    term.hash += hash_of(atom);
  }

  std::vector<Atom> atoms_;
  std::vector<char> is_constant_; // per atom
};

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
