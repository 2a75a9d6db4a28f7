#include "engine/optimise/algebra/expansion.h"

#include <cstdlib>
#include <optional>

namespace symreal::algebra {

namespace {

constexpr std::size_t longest_sum = 60;
// In atoms. Without it, each squaring in a chain would double the powers.
constexpr std::size_t longest_product = 64;

std::size_t longest_term(Sum const &sum) {
  std::size_t longest = 0;
  for (Term const &term : sum) longest = std::max(longest, term.size());
  return longest;
}

class Expander {
public:
  Expander(Network const &network, ExpansionSettings const &settings)
      : network_(network),
        settings_(settings),
        uses_(network.size(), 0),
        fixed_(network.size(), 0),
        is_root_(network.size(), 0),
        bodies_(network.size()) {}

  Expansion run() {
    std::vector<char> const live = live_nodes(network_);
    count_uses(live);
    for (Index node = 0; node < network_.size(); ++node)
      if (live[node] && is_expandable(network_[node])) {
        bodies_[node] = body(network_[node]);
        is_root_[node] = fixed_[node] || (uses_[node] > 1 && !is_repeated(node));
      }
    result_.atoms = static_cast<Atom>(network_.size());
    mark_needed();
    for (Index node = 0; node < network_.size(); ++node)
      if (is_root_[node] && is_needed_[node]) result_.expressions.push_back({node, std::move(bodies_[node])});
    for (Expression &expression : result_.expressions)
      for (Term &term : expression.terms) make_integers_atoms(term);
    return std::move(result_);
  }

private:
  static bool is_expandable(NetworkNode const &node) {
    return !node.is_free() && (node.kind == Kind::sum || node.kind == Kind::product);
  }

  void count_uses(std::vector<char> const &live) {
    for (Index index = 0; index < network_.size(); ++index) {
      if (!live[index]) continue;
      NetworkNode const &node = network_[index];
      network_.for_each_operand(node, [&](Literal operand) {
        ++uses_[operand.node()];
        if (!is_expandable(node)) fixed_[operand.node()] = 1;
      });
    }
    for (Literal root : network_.roots) fixed_[root.node()] = 1;
  }

  bool is_repeated(Index node) const {
    Sum const &terms = bodies_[node];
    if (terms.size() == 1 && terms[0].size() <= static_cast<std::size_t>(settings_.product_size)) return true;
    return terms.size() <= static_cast<std::size_t>(settings_.sum_size) && uses_[node] <= settings_.most_uses;
  }

  // Terms that a literal contributes to its user: its atom, or its expansion.
  Sum terms_of(Literal literal) {
    Sum sum;
    if (literal.node() == network_.zero().node()) return sum;
    NetworkNode const &node = network_[literal];
    if (node.is_free())
      sum = {constant(literal.node())};
    else if (!is_expandable(node) || is_root_[literal.node()])
      sum = {result_.store.single(literal.node())};
    else
      sum = bodies_[literal.node()];
    if (literal.is_negative())
      for (Term &term : sum) term.coefficient = -term.coefficient;
    return sum;
  }

  // Factors of a free node, each an atom.
  Term constant(Index index) {
    std::vector<Atom> factors;
    std::vector<Index> open = {index};
    while (!open.empty()) {
      NetworkNode const &node = network_[open.back()];
      Index const at = open.back();
      open.pop_back();
      if (node.kind == Kind::product && factors.size() + open.size() < 8) {
        open.push_back(node.a.node());
        open.push_back(node.b.node());
      } else if (at != network_.one().node()) {
        factors.push_back(at);
        result_.store.set_constant(at);
      }
    }
    std::ranges::sort(factors);
    return result_.store.make(factors);
  }

  Sum body(NetworkNode const &node) {
    Sum a = terms_of(node.a), b = terms_of(node.b);
    if (node.kind == Kind::sum) {
      if (a.size() + b.size() > longest_sum) close(a.size() < b.size() ? node.b : node.a, a.size() < b.size() ? b : a);
      a.insert(a.end(), b.begin(), b.end());
      return collected(a);
    }
    auto const is_long = [&] {
      return a.size() * b.size() > static_cast<std::size_t>(settings_.most_terms) ||
             longest_term(a) + longest_term(b) > longest_product;
    };
    if (is_long() && a.size() >= b.size()) close(node.a, a);
    if (is_long()) close(node.b, b);
    if (is_long()) close(node.a, a);
    Sum product;
    for (Term const &x : a)
      for (Term const &y : b) product.push_back(result_.store.product(x, y));
    return collected(product);
  }

  // Gives the operand an expression of its own.
  void close(Literal operand, Sum &terms) {
    if (!is_expandable(network_[operand])) return;
    is_root_[operand.node()] = 1;
    terms = terms_of(operand);
  }

  // Merges equal products.
  static Sum collected(Sum const &sum) {
    Sum result;
    for (Term const &term : sum) {
      auto const same = std::ranges::find(result, term.hash, &Term::hash);
      if (same == result.end())
        result.push_back(term);
      else
        same->coefficient += term.coefficient;
    }
    std::erase_if(result, [](Term const &term) { return term.coefficient == 0; });
    return result;
  }

  // An expression may use the expansion of a node that was closed later; this marks the expressions that are used.
  void mark_needed() {
    is_needed_.assign(network_.size(), 0);
    for (auto index = static_cast<Index>(network_.size()); index-- > 0;) {
      if (fixed_[index]) is_needed_[index] = 1;
      if (!is_needed_[index] || !is_root_[index]) continue;
      for (Term const &term : bodies_[index])
        for (Atom atom : result_.store.atoms(term)) is_needed_[atom] = 1;
    }
  }

  void make_integers_atoms(Term &term) {
    int const size = std::abs(term.coefficient), sign = term.coefficient < 0 ? -1 : 1;
    if (size != 1) {
      auto known = std::ranges::find(result_.integers, size, &std::pair<Atom, int>::second);
      if (known == result_.integers.end()) {
        result_.store.set_constant(result_.atoms);
        known = result_.integers.insert(known, {result_.atoms++, size});
      }
      term.coefficient = 1;
      term = result_.store.product(term, result_.store.single(known->first));
    }
    term.coefficient = sign;
  }

  Network const &network_;
  ExpansionSettings const &settings_;
  std::vector<int> uses_;
  std::vector<char> fixed_, is_root_, is_needed_;
  std::vector<Sum> bodies_;
  Expansion result_;
};

} // namespace

Expansion expand(Network const &network, ExpansionSettings const &settings) {
  return Expander(network, settings).run();
}

} // namespace symreal::algebra
