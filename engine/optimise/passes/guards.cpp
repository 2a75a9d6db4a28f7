// A guard that others imply is dropped: first those that follow from earlier ones, then those that follow from later
// ones, as x >= 1 does from x >= 2. So of a chain of thresholds two are left.
//
// What is known after some guards: for a pair of operands which outcomes of comparing them are possible; for an operand
// that is compared with constants also an interval; for any other condition its truth. A conjunction is two facts. What
// an operand can be at all counts too: an index that was clamped needs no guard.
#include "engine/graph/relations.h"
#include "engine/graph/value_range.h"
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

  // Whether the literal follows from what was learnt.
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

  // False when nothing can satisfy both the literal and what was learnt before.
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
  // x compared with y, x being the older node, or with a constant; an empty set for what is no comparison.
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
    return strict_ ? any : any & ~unordered; // the others presume that no value is a NaN
  }

  static double after(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
  static double before(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

  // Less or greater than the constant: no interval.
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

// What holds with the condition, none of it a conjunction.
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

// Whether the guard adds something to what is known, which then knows it. Fails where the two contradict each other.
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
  // A call stands behind the guards before it, which therefore stay.
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
