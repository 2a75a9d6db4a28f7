#include "engine/optimise/algebra/key_table.h"
#include "engine/optimise/algebra/search.h"

#include <iterator>

namespace symreal::algebra {

namespace {

// Candidates for common subexpressions: sums of two terms that divide other sums, and products of two atoms.
//
// In terms of logic synthesis: two-term kernels and two-literal cubes, found as in the fast extraction of Rajski and
// Vasudevamurthy. Each candidate counts the operations that it saves.
using CandidateId = std::uint32_t;

struct Candidate {
  std::uint64_t key;
  bool is_pair; // a product of two atoms, else a sum
  std::uint32_t first_atom, second_atom;
  int saving = 0; // total of all uses
  int cost;       // of one computation
  int level = 0;  // current bucket
  std::uint32_t last_use = KeyTable::none;

  int gain() const { return saving - cost; }
};

// Bucket queue of candidates by gain. An outdated gain is corrected when its candidate is taken.
class Candidates {
public:
  // `noise` is the probability of a near-best candidate. `sums_first` breaks ties in favour of sums.
  Candidates(SearchState &search, double noise, bool sums_first)
      : search_(search),
        noise_(noise),
        sums_first_(sums_first) {}

  // Adds or removes a use of the candidate with this key.
  void add(Candidate const &made, int saving, std::uint32_t expression) {
    std::uint32_t &number = numbers_[made.key];
    if (number == KeyTable::none) {
      number = static_cast<CandidateId>(candidates_.size());
      candidates_.push_back(made);
    }
    CandidateId const id = number;
    Candidate &candidate = candidates_[id];
    candidate.saving += saving;
    if (candidate.last_use == KeyTable::none || uses_[candidate.last_use].expression != expression) {
      uses_.push_back({expression, candidate.last_use});
      candidate.last_use = static_cast<std::uint32_t>(uses_.size() - 1);
    }
    enqueue(id);
  }
  void remove(std::uint64_t key, int saving) {
    if (CandidateId const id = numbers_.find(key); id != KeyTable::none) candidates_[id].saving -= saving;
  }

  // The best or a near-best candidate; nullopt if no candidate saves anything.
  std::optional<Candidate> take() {
    while (true) {
      while (highest_ > 0 && waiting_[highest_].empty()) --highest_;
      if (highest_ <= 0) return std::nullopt;
      int level = highest_;
      if (noise_ > 0 && search_.chance() < noise_)
        for (int lower : {highest_ - 1, highest_ - 2})
          if (lower > 0 && !waiting_[lower].empty()) {
            level = lower;
            break;
          }
      std::vector<CandidateId> &bucket = waiting_[level];
      std::swap(bucket[search_.random() % bucket.size()], bucket.back());
      CandidateId const id = bucket.back();
      bucket.pop_back();
      Candidate &candidate = candidates_[id];
      if (candidate.level == level) candidate.level = 0;
      int const now = level_of(candidate);
      if (now == level) return candidate;
      if (now > 0 && now < level) enqueue(id);
    }
  }

  // Expressions that may use the candidate, ascending.
  std::vector<std::uint32_t> uses(Candidate const &candidate) const {
    std::vector<std::uint32_t> expressions;
    for (std::uint32_t use = candidate.last_use; use != KeyTable::none; use = uses_[use].previous)
      expressions.push_back(uses_[use].expression);
    std::ranges::sort(expressions);
    auto const repeated = std::ranges::unique(expressions);
    expressions.erase(repeated.begin(), repeated.end());
    return expressions;
  }

private:
  struct Use {
    std::uint32_t expression, previous;
  };

  int level_of(Candidate const &candidate) const {
    return 2 * candidate.gain() - (candidate.is_pair && sums_first_ ? 1 : 0);
  }

  void enqueue(CandidateId id) {
    Candidate &candidate = candidates_[id];
    int const level = level_of(candidate);
    if (level <= 0 || level <= candidate.level) return;
    candidate.level = level;
    if (waiting_.size() <= static_cast<std::size_t>(level)) waiting_.resize(level + 1);
    waiting_[level].push_back(id);
    highest_ = std::max(highest_, level);
  }

  SearchState &search_;
  double noise_;
  bool sums_first_;
  KeyTable numbers_;
  std::vector<Candidate> candidates_;
  std::vector<Use> uses_;
  std::vector<std::vector<CandidateId>> waiting_; // indexed by level
  int highest_ = 0;
};

std::uint64_t key_of_product(Atom p, Atom q) { return mixed((std::uint64_t{p} << 32 | q) ^ 0xA5A5A5A5u); }

// The term with the smaller hash comes first in a divisor.
std::uint64_t key_of_sum(std::uint64_t a, std::uint64_t b, bool minus) {
  if (b < a) std::swap(a, b);
  return mixed(mixed(a) + b + static_cast<std::uint64_t>(minus));
}

// Whether the cofactors of both terms contain only parameters and numbers.
bool is_free(Term const &x, Term const &y, Common const &common) {
  return x.variables == common.variables && y.variables == common.variables;
}

// Extraction of common divisors from sums of products, one at a time.
class Extraction {
public:
  Extraction(Expansion &expansion, Candidates &candidates, SearchState &search)
      : expansion_(expansion),
        store_(expansion.store),
        candidates_(candidates),
        search_(search) {}

  void run() {
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

private:
  using ExpressionId = std::uint32_t;

  // Sum of both terms without their common part, normalised to a positive first term.
  Candidate divisor(Term const &x, Term const &y, Common const &common) const {
    auto multiplications = [&](Term const &term) {
      int const constants = term.constants - common.constants;
      return std::max(term.variables - common.variables + (constants > 0) - 1, 0);
    };
    Candidate candidate{};
    candidate.key = key_of_sum(x.hash - common.hash, y.hash - common.hash, x.coefficient != y.coefficient);
    candidate.cost = is_free(x, y, common) ? 0 : multiplications(x) + multiplications(y) + 1;
    return candidate;
  }

  void count_pair(ExpressionId id, Term const &x, Term const &y, int sign) {
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

  bool may_join(Term const &term, Atom p, Atom q) const {
    bool const p_constant = store_.is_constant(p), q_constant = store_.is_constant(q);
    if (p_constant && q_constant) return false; // free
    return (!p_constant && !q_constant) || term.constants == 1;
  }

  void count_atoms(ExpressionId id, Term const &term, int sign) {
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
  void count_term(ExpressionId id, std::size_t at, int sign) {
    Sum const &terms = expansion_.expressions[id].terms;
    for (std::size_t other = 0; other < terms.size(); ++other)
      if (other != at) count_pair(id, terms[at], terms[other], sign);
    count_atoms(id, terms[at], sign);
  }

  void count(ExpressionId id) {
    Sum const &terms = expansion_.expressions[id].terms;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      for (std::size_t j = i + 1; j < terms.size(); ++j) count_pair(id, terms[i], terms[j], 1);
      count_atoms(id, terms[i], 1);
    }
  }

  void remove_term(ExpressionId id, std::size_t at) {
    count_term(id, at, -1);
    Sum &terms = expansion_.expressions[id].terms;
    terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(at));
  }

  void add_term(ExpressionId id, Term const &term) {
    Sum &terms = expansion_.expressions[id].terms;
    terms.push_back(term);
    count_term(id, terms.size() - 1, 1);
  }

  ExpressionId define(Sum terms) {
    expansion_.expressions.push_back({expansion_.atoms++, std::move(terms)});
    return static_cast<ExpressionId>(expansion_.expressions.size() - 1);
  }

  void extract_product(Candidate const &candidate) {
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
  Term without(Term const &term, Term const &other) {
    std::vector<Atom> rest;
    std::ranges::set_difference(store_.atoms(term), store_.atoms(other), std::back_inserter(rest));
    return store_.make(rest);
  }

  bool extract_sum_once(ExpressionId id, Candidate const &candidate, Atom &made) {
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

  void extract_sum(Candidate const &candidate) {
    Atom made = KeyTable::none;
    std::size_t const defined = expansion_.expressions.size();
    for (ExpressionId id : candidates_.uses(candidate))
      while (extract_sum_once(id, candidate, made)) {
      }
    if (made != KeyTable::none && !store_.is_constant(made)) count(static_cast<ExpressionId>(defined));
  }

  Expansion &expansion_;
  TermStore &store_;
  Candidates &candidates_;
  SearchState &search_;
};

// Builds a network from the expressions and the old nodes that they use.
class Assembly {
public:
  Assembly(Network const &old, Expansion const &expansion)
      : old_(old),
        expansion_(expansion),
        expression_(expansion.atoms, no_index),
        now_(expansion.atoms),
        is_done_(expansion.atoms, 0),
        result_(old.context()) {
    for (Index i = 0; i < expansion.expressions.size(); ++i) expression_[expansion.expressions[i].atom] = i;
    for (auto const &[atom, integer] : expansion.integers) {
      now_[atom] = result_.constant(static_cast<double>(integer));
      is_done_[atom] = 1;
    }
  }

  Network run() {
    for (Literal root : old_.roots) make(root.node());
    for (Literal root : old_.roots) result_.roots.push_back(now_(root));
    return std::move(result_);
  }

private:
  template <class Visit> void for_each_need(Atom atom, Visit const &visit) const {
    if (expression_[atom] == no_index) {
      old_.for_each_operand(old_[atom], [&](Literal operand) { visit(operand.node()); });
      return;
    }
    for (Term const &term : expansion_.expressions[expression_[atom]].terms)
      for (Atom factor : expansion_.store.atoms(term)) visit(factor);
  }

  // Builds operands first; uses an explicit stack, since expressions are deep.
  void make(Atom root) {
    std::vector<Atom> open = {root};
    while (!open.empty()) {
      Atom const atom = open.back();
      std::size_t const before = open.size();
      if (!is_done_[atom])
        for_each_need(atom, [&](Atom need) {
          if (!is_done_[need]) open.push_back(need);
        });
      if (open.size() != before) continue;
      open.pop_back();
      if (std::exchange(is_done_[atom], 1)) continue;
      now_[atom] = expression_[atom] == no_index ? result_.copy(old_, old_[atom], now_)
                                                 : sum(expansion_.expressions[expression_[atom]].terms);
    }
  }

  Literal sum(Sum const &terms) {
    Literal constants = result_.zero(), variables = result_.zero();
    for (Term const &term : terms) {
      Literal &part = term.variables == 0 ? constants : variables;
      part = result_.sum(part, product(term));
    }
    return result_.sum(variables, constants);
  }

  Literal product(Term const &term) {
    Literal constants = result_.one(), variables = result_.one();
    for (Atom atom : expansion_.store.atoms(term)) {
      Literal &part = expansion_.store.is_constant(atom) ? constants : variables;
      part = result_.product(part, now_[atom]);
    }
    return result_.product(constants, variables).negated_if(term.coefficient < 0);
  }

  Network const &old_;
  Expansion const &expansion_;
  std::vector<Index> expression_; // per atom
  LiteralMap now_;
  std::vector<char> is_done_;
  Network result_;
};

} // namespace

Network factored(Network const &network, FactoringSettings const &settings, SearchState &search) {
  Expansion expansion = expand(network, settings.expansion);
  Candidates candidates(search, settings.noise, settings.sums_first);
  Extraction(expansion, candidates, search).run();
  Network result = Assembly(network, expansion).run();
  // A hash collision between terms would have changed a value.
  for (std::size_t i = 0; i < network.roots.size(); ++i)
    if (!equal_in_field(result.value(result.roots[i]), network.value(network.roots[i]))) return network;
  return result;
}

} // namespace symreal::algebra
