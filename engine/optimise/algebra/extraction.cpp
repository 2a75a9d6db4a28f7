#include "engine/optimise/algebra/extraction.h"

#include <iterator>

namespace symreal::algebra {

namespace {

std::uint64_t key_of_product(Atom p, Atom q) { return mixed((std::uint64_t{p} << 32 | q) ^ 0xA5A5A5A5u); }

// The term with the smaller hash comes first in a divisor.
std::uint64_t key_of_sum(std::uint64_t a, std::uint64_t b, bool minus) {
  if (b < a) std::swap(a, b);
  return mixed(mixed(a) + b + static_cast<std::uint64_t>(minus));
}

} // namespace

void Extraction::run() {
  for (ExpressionId id = 0; id < expansion_.expressions.size() && !search_.is_over(); ++id) count(id);
  while (!search_.is_over()) {
    std::optional<Candidate> const best = candidates_.take();
    if (!best) return;
    if (best->is_pair)
      extract_product(*best);
    else
      extract_sum(*best);
  }
}

// Whether the cofactors of both terms contain only parameters and numbers.
bool Extraction::is_free(Term const &x, Term const &y, Common const &common) {
  return x.variables == common.variables && y.variables == common.variables;
}

// Sum of both terms without their common part, normalised to a positive first term.
Candidate Extraction::divisor(Term const &x, Term const &y, Common const &common) const {
  auto multiplications = [&](Term const &term) {
    int const constants = term.constants - common.constants;
    return std::max(term.variables - common.variables + (constants > 0) - 1, 0);
  };
  Candidate candidate{};
  candidate.key = key_of_sum(x.hash - common.hash, y.hash - common.hash, x.coefficient != y.coefficient);
  candidate.cost = is_free(x, y, common) ? 0 : multiplications(x) + multiplications(y) + 1;
  return candidate;
}

void Extraction::count_pair(ExpressionId id, Term const &x, Term const &y, int sign) {
  ++search_.work;
  Common const common = store_.common(x, y);
  // Two products and a sum become one product with the divisor.
  int const factors = common.variables + (common.constants > 0 || is_free(x, y, common));
  int const multiplications = is_free(x, y, common) ? std::max(factors - 1, 0) : factors;
  int const saving = x.multiplications() + y.multiplications() + 1 - multiplications;
  Candidate const candidate = divisor(x, y, common);
  if (sign > 0)
    candidates_.add(candidate, saving, id);
  else
    candidates_.remove(candidate.key, saving);
}

bool Extraction::may_join(Term const &term, Atom p, Atom q) const {
  bool const p_constant = store_.is_constant(p), q_constant = store_.is_constant(q);
  if (p_constant && q_constant) return false; // free
  return (!p_constant && !q_constant) || term.constants == 1;
}

void Extraction::count_atoms(ExpressionId id, Term const &term, int sign) {
  std::span<Atom const> const atoms = store_.atoms(term);
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (i > 0 && atoms[i] == atoms[i - 1]) continue;
    for (std::size_t j = i + 1; j < atoms.size(); ++j) {
      bool const is_repeated = j > i + 1 && atoms[j] == atoms[j - 1];
      if (is_repeated || !may_join(term, atoms[i], atoms[j])) continue;
      ++search_.work;
      Candidate candidate{key_of_product(atoms[i], atoms[j]), true, atoms[i], atoms[j], 0, 1};
      if (sign > 0)
        candidates_.add(candidate, 1, id);
      else
        candidates_.remove(candidate.key, 1);
    }
  }
}

// Counts all candidates of one term of an expression.
void Extraction::count_term(ExpressionId id, std::size_t at, int sign) {
  Sum const &terms = expansion_.expressions[id].terms;
  for (std::size_t other = 0; other < terms.size(); ++other)
    if (other != at) count_pair(id, terms[at], terms[other], sign);
  count_atoms(id, terms[at], sign);
}

void Extraction::count(ExpressionId id) {
  Sum const &terms = expansion_.expressions[id].terms;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    for (std::size_t j = i + 1; j < terms.size(); ++j) count_pair(id, terms[i], terms[j], 1);
    count_atoms(id, terms[i], 1);
  }
}

void Extraction::remove_term(ExpressionId id, std::size_t at) {
  count_term(id, at, -1);
  Sum &terms = expansion_.expressions[id].terms;
  terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(at));
}

void Extraction::add_term(ExpressionId id, Term const &term) {
  Sum &terms = expansion_.expressions[id].terms;
  terms.push_back(term);
  count_term(id, terms.size() - 1, 1);
}

Extraction::ExpressionId Extraction::define(Sum terms) {
  expansion_.expressions.push_back({expansion_.atoms++, std::move(terms)});
  return static_cast<ExpressionId>(expansion_.expressions.size() - 1);
}

void Extraction::extract_product(Candidate const &candidate) {
  Atom const p = candidate.first_atom, q = candidate.second_atom;
  Atom const made = expansion_.atoms;
  for (ExpressionId id : candidates_.uses(candidate)) {
    for (std::size_t at = 0; at < expansion_.expressions[id].terms.size();) {
      Term const term = expansion_.expressions[id].terms[at];
      std::span<Atom const> const atoms = store_.atoms(term);
      auto const first = std::ranges::find(atoms, p);
      bool const has_both = first != atoms.end() && std::find(first + 1, atoms.end(), q) != atoms.end();
      if (!has_both || !may_join(term, p, q)) {
        ++at;
        continue;
      }
      std::vector<Atom> rest(atoms.begin(), atoms.end());
      rest.erase(std::ranges::find(rest, p));
      rest.erase(std::ranges::find(rest, q));
      rest.push_back(made); // the highest atom, so the list stays sorted
      remove_term(id, at);
      Term product = store_.make(rest);
      product.coefficient = term.coefficient;
      add_term(id, product);
    }
  }
  std::array<Atom, 2> const both = {p, q};
  count(define({store_.make(both)}));
}

// Atoms of `term` that `other` lacks, as a term.
Term Extraction::without(Term const &term, Term const &other) {
  std::vector<Atom> rest;
  std::ranges::set_difference(store_.atoms(term), store_.atoms(other), std::back_inserter(rest));
  return store_.make(rest);
}

bool Extraction::extract_sum_once(ExpressionId id, Candidate const &candidate, Atom &made) {
  Sum const &terms = expansion_.expressions[id].terms;
  for (std::size_t i = 0; i < terms.size(); ++i)
    for (std::size_t j = i + 1; j < terms.size(); ++j) {
      Term x = terms[i], y = terms[j];
      Common const common = store_.common(x, y);
      ++search_.work;
      if (divisor(x, y, common).key != candidate.key) continue;
      if (y.hash - common.hash < x.hash - common.hash) std::swap(x, y);
      Term rest_x = without(x, y), rest_y = without(y, x);
      std::vector<Atom> product;
      std::ranges::set_intersection(store_.atoms(x), store_.atoms(y), std::back_inserter(product));
      int const sign = x.coefficient;
      if (made == KeyTable::none) {
        rest_y.coefficient = x.coefficient * y.coefficient;
        made = expansion_.expressions[define({rest_x, rest_y})].atom;
        if (is_free(x, y, common)) store_.set_constant(made);
      }
      product.push_back(made);
      remove_term(id, j);
      remove_term(id, i);
      Term term = store_.make(product);
      term.coefficient = sign;
      add_term(id, term);
      return true;
    }
  return false;
}

void Extraction::extract_sum(Candidate const &candidate) {
  Atom made = KeyTable::none;
  std::size_t const defined = expansion_.expressions.size();
  for (ExpressionId id : candidates_.uses(candidate))
    while (extract_sum_once(id, candidate, made)) {
    }
  if (made != KeyTable::none && !store_.is_constant(made)) count(static_cast<ExpressionId>(defined));
}

} // namespace symreal::algebra
