#include "engine/optimise/algebra/factoring.h"

#include "engine/optimise/algebra/extraction.h"

#include <utility>

namespace symreal::algebra {

namespace {

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
    for (Literal root : old_.roots) result_.roots.push_back(now_[root.node()].negated_if(root.is_negative()));
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
      now_[atom] =
          expression_[atom] == no_index
              ? result_.copy(old_, old_[atom],
                             [&](Literal operand) { return now_[operand.node()].negated_if(operand.is_negative()); })
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
  std::vector<Literal> now_;
  std::vector<char> is_done_;
  Network result_;
};

} // namespace

Network factored(Network const &network, FactoringSettings const &settings, Search &search) {
  Expansion expansion = expand(network, settings.expansion);
  Candidates candidates(search.random, settings.noise, settings.sums_first);
  Extraction(expansion, candidates, search).run();
  Network result = Assembly(network, expansion).run();
  // A hash collision between terms would have changed a value.
  for (std::size_t i = 0; i < network.roots.size(); ++i)
    if (!equal_in_field(result.value(result.roots[i]), network.value(network.roots[i]))) return network;
  return result;
}

} // namespace symreal::algebra
