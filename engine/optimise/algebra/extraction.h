// Extraction of common divisors from sums of products, one at a time.
#pragma once

#include "engine/optimise/algebra/candidates.h"
#include "engine/optimise/algebra/expansion.h"
#include "engine/optimise/algebra/search.h"

namespace symreal::algebra {

class Extraction {
public:
  Extraction(Expansion &expansion, Candidates &candidates, Search &search)
      : expansion_(expansion),
        store_(expansion.store),
        candidates_(candidates),
        search_(search) {}

  void run();

private:
  using ExpressionId = std::uint32_t;

  static bool is_free(Term const &x, Term const &y, Common const &common);
  Candidate divisor(Term const &x, Term const &y, Common const &common) const;
  void count_pair(ExpressionId id, Term const &x, Term const &y, int sign);
  void count_atoms(ExpressionId id, Term const &term, int sign);
  void count_term(ExpressionId id, std::size_t at, int sign);
  void count(ExpressionId id);
  void remove_term(ExpressionId id, std::size_t at);
  void add_term(ExpressionId id, Term const &term);

  ExpressionId define(Sum terms);
  bool may_join(Term const &term, Atom p, Atom q) const;
  void extract_product(Candidate const &candidate);
  void extract_sum(Candidate const &candidate);
  bool extract_sum_once(ExpressionId id, Candidate const &candidate, Atom &made);
  Term without(Term const &term, Term const &other);

  Expansion &expansion_;
  TermStore &store_;
  Candidates &candidates_;
  Search &search_;
};

} // namespace symreal::algebra
