// Removal of implied guards: first those that earlier guards imply, then those that later ones imply, as x >= 2 implies
// x >= 1. A chain of thresholds keeps two.
//
// Facts after some guards: the possible outcomes of comparing a pair of operands, the interval of an operand compared
// with constants, and the truth of any other condition. A conjunction gives two facts. The static range of an operand
// counts too: a clamped index needs no guard.
#include "engine/graph/value_range.h"
#include "engine/ops/operation.h"
#include "engine/optimise/passes/pass.h"

#include <cmath>
#include <limits>
#include <unordered_map>

namespace symreal {

namespace {

using namespace relation;

struct Literal {
  NodeId condition;
  bool holds;
};

class Knowledge {
public:
  Knowledge(Graph const &graph, FloatingPoint mode)
      : graph_(graph),
        strict_(mode == FloatingPoint::strict),
        ranges_(graph, mode) {}

  // Whether the facts imply the literal.
  bool implies(Literal const &literal) const {
    Comparison const comparison = view(literal);
    if (!comparison.set) {
      auto known = truth_.find(literal.condition);
      return known != truth_.end() && known->second == literal.holds;
    }
    unsigned const possible = possible_outcomes(comparison);
    if ((possible & ~comparison.set) == 0) return true;
    if (!comparison.constant) return false;
    Interval const known = ranges_.range(comparison.x);
    if (is_point_excluded(comparison)) return *comparison.constant < known.low || *comparison.constant > known.high;
    return known.within(allowed(comparison, *comparison.constant));
  }

  // Adds the literal to the facts; false if it contradicts them.
  bool learn(Literal const &literal) {
    Comparison const comparison = view(literal);
    if (!comparison.set) return truth_.emplace(literal.condition, literal.holds).first->second == literal.holds;
    unsigned const possible = possible_outcomes(comparison) & comparison.set;
    outcomes_[key(comparison)] = possible;
    if (!comparison.constant) return possible != 0;
    Interval known = ranges_.range(comparison.x);
    if (is_point_excluded(comparison)) {
      if (known.low == *comparison.constant) known.low = after(known.low);
      if (known.high == *comparison.constant) known.high = before(known.high);
    } else {
      Interval const other = allowed(comparison, *comparison.constant);
      known = {std::max(known.low, other.low), std::min(known.high, other.high), known.nan && other.nan};
    }
    ranges_.narrow(comparison.x, known);
    return possible != 0 && !known.empty();
  }

private:
  // Comparison of x, the older node, with y or a constant; its set is empty if the condition does not compare.
  struct Comparison {
    NodeId x, y;
    unsigned set;
    std::optional<double> constant;
  };

  Comparison view(Literal const &literal) const {
    Node const &node = graph_.nodes[literal.condition];
    unsigned set = is_leaf(node.op) ? 0 : held_by(node.op);
    if (set == 0) return {no_node, no_node, 0, {}};
    if (!literal.holds) set = any & ~set;
    NodeId x = node.operand[0], y = node.operand[1];
    bool const x_is_constant = graph_.nodes[x].is_constant();
    if (x_is_constant || (x > y && !graph_.nodes[y].is_constant())) {
      std::swap(x, y);
      set = mirrored(set);
    }
    Comparison result{x, y, set, {}};
    Node const &other = graph_.nodes[y];
    if (other.is_constant() && std::isfinite(other.value())) result.constant = other.value();
    return result;
  }

  static std::uint64_t key(Comparison const &comparison) { return std::uint64_t{comparison.x} << 32 | comparison.y; }

  unsigned possible_outcomes(Comparison const &comparison) const {
    auto known = outcomes_.find(key(comparison));
    if (known != outcomes_.end()) return known->second;
    return strict_ ? any : any & ~unordered; // other modes assume that no value is NaN
  }

  static double after(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
  static double before(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

  // Whether the allowed values are all but the constant, which no interval describes.
  static bool is_point_excluded(Comparison const &comparison) {
    return (comparison.set & any & ~unordered) == (less | greater);
  }

  static Interval allowed(Comparison const &comparison, double c) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    bool const with_equal = comparison.set & equal;
    Interval result{with_equal ? c : after(c), with_equal ? c : before(c), (comparison.set & unordered) != 0};
    if (comparison.set & less) result.low = -infinity;
    if (comparison.set & greater) result.high = infinity;
    return result;
  }

  Graph const &graph_;
  bool strict_;
  ValueRanges ranges_;
  std::unordered_map<std::uint64_t, unsigned> outcomes_;
  std::unordered_map<NodeId, bool> truth_;
};

// Literals that the condition implies, with conjunctions split.
std::vector<Literal> facts(Graph const &graph, NodeId condition) {
  std::vector<Literal> result, stack = {{condition, true}};
  while (!stack.empty()) {
    Literal const literal = stack.back();
    stack.pop_back();
    Node const &node = graph.nodes[literal.condition];
    if (node.op == Op::logical_not) {
      stack.push_back({node.operand[0], !literal.holds});
    } else if (node.op == (literal.holds ? Op::logical_and : Op::logical_or)) {
      stack.push_back({node.operand[1], literal.holds});
      stack.push_back({node.operand[0], literal.holds});
    } else {
      result.push_back(literal);
    }
  }
  return result;
}

[[noreturn]] void report(Graph const &graph, Guard const &guard, FloatingPoint mode) {
  fail(DiagnosticId::contradictory_guard, place_at(graph, guard.location),
       "the guard " + guard.text + " can never hold together with those before it in mode " +
           std::string(to_string(mode)));
}

// Whether the guard adds a fact to `knowledge`, which learns it. Fails if the guard contradicts it.
bool adds(Graph const &graph, Guard const &guard, FloatingPoint mode, Knowledge &knowledge) {
  bool adds = false;
  for (Literal const &fact : facts(graph, guard.condition)) {
    Node const &node = graph.nodes[fact.condition];
    if (node.is_constant() ? (node.value() != 0) == fact.holds : knowledge.implies(fact)) continue;
    adds = true;
    if (node.is_constant() || !knowledge.learn(fact)) report(graph, guard, mode);
  }
  return adds;
}

} // namespace

Graph pass_guards(Graph graph, PassSettings const &settings) {
  FloatingPoint const mode = settings.mode;
  if (graph.guards.empty()) return graph;
  Knowledge knowledge(graph, mode);
  std::erase_if(graph.guards, [&](Guard const &guard) { return !adds(graph, guard, mode, knowledge); });
  // A call executes after the guards before it, so they stay.
  if (graph.externals.empty()) {
    Knowledge later(graph, mode);
    std::vector<Guard> kept;
    for (auto guard = graph.guards.rbegin(); guard != graph.guards.rend(); ++guard)
      if (adds(graph, *guard, mode, later)) kept.push_back(*guard);
    graph.guards.assign(kept.rbegin(), kept.rend());
  }
  keep_nodes(graph, live_nodes(graph));
  return graph;
}

} // namespace symreal
