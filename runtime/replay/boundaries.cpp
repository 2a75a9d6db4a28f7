#include "runtime/replay/boundaries.h"

#include "engine/graph/evaluate.h"

#include <algorithm>
#include <cmath>

namespace symreal {

namespace {

bool is_joint(Op op) { return !is_leaf(op) && info(op).has(flag::LOGICAL); }

bool is_select(Op op) { return op == Op::select || op == Op::wide_select; }

} // namespace

std::vector<Decision> decisions_of(Graph const &graph) {
  // A location where the node is, or belongs to, a condition.
  std::vector<char> is_condition(graph.nodes.size(), 0);
  std::vector<Decision> of_node(graph.nodes.size());
  auto note = [&](NodeId id, LocationId location, bool is_guards) {
    if (is_condition[id] && (of_node[id].is_guards || !is_guards)) return;
    is_condition[id] = 1;
    of_node[id] = {id, location, is_guards};
  };
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (live[id] && is_select(node.op))
      note(node.operand[0], graph.node_location.empty() ? no_location : graph.node_location[id], false);
  }
  for (Guard const &guard : graph.guards) note(guard.condition, guard.location, true);
  std::vector<Decision> decisions;
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    Node const &node = graph.nodes[id];
    if (!is_condition[id] || node.attribute == Attribute::constant) continue;
    if (!is_joint(node.op))
      decisions.push_back(of_node[id]);
    else
      for (NodeId operand : node.operand)
        if (operand != no_node) note(operand, of_node[id].location, of_node[id].is_guards);
  }
  std::ranges::reverse(decisions);
  return decisions;
}

double margin_of(Graph const &graph, NodeId condition, std::span<double const> values) {
  Node const &node = graph.nodes[condition];
  bool const compares = !is_leaf(node.op) && info(node.op).has(flag::BOOLEAN) && info(node.op).form == Form::infix &&
                        !info(node.op).has(flag::TAKES_WIDE);
  return compares ? values[node.operand[0]] - values[node.operand[1]] : values[condition];
}

namespace {

constexpr std::size_t drawn_samples = 200, most_pairs = 3, most_moved = 16, most_evaluated_nodes = 200'000'000;
constexpr int most_halvings = 120;

struct Sides {
  std::vector<Sample> yes, no;
  bool are_met() const { return !yes.empty() && !no.empty(); }
};

class BoundarySearch {
public:
  BoundarySearch(Graph const &graph, std::uint64_t seed, double apart)
      : graph_(graph),
        source_(graph, seed),
        halvings_(apart == 0 ? most_halvings : static_cast<int>(-std::log2(apart))),
        decisions_(decisions_of(graph)) {
    sides_.resize(decisions_.size());
    for (Object const &object : graph.inputs) ranges_.insert(ranges_.end(), object.count, object.range);
  }

  Boundaries run() {
    Boundaries result{{}, decisions_.size(), 0};
    if (decisions_.empty()) return result;
    for (std::size_t k = 0; k < drawn_samples && has_time(); ++k) look_at(source_.next());
    for (std::size_t k = 0; k < decisions_.size() && has_time(); ++k) {
      if (!sides_[k].are_met()) reach_other_side(k);
      Sides const &sides = sides_[k];
      result.crossed += sides.are_met();
      for (std::size_t pair = 0; pair < std::min(sides.yes.size(), sides.no.size()); ++pair)
        bisect(decisions_[k].condition, sides.yes[pair], sides.no[pair], result.samples);
    }
    return result;
  }

private:
  bool has_time() const { return evaluated_ < most_evaluated_nodes; }

  std::vector<double> values_at(Sample const &sample) {
    evaluated_ += graph_.nodes.size();
    return evaluate(graph_, sample.inputs, sample.parameters);
  }

  // A decision counts where the program comes to it.
  void look_at(Sample const &sample) {
    std::vector<double> const values = values_at(sample);
    std::vector<char> const active = active_nodes(graph_, values);
    for (std::size_t k = 0; k < decisions_.size(); ++k) {
      NodeId const condition = decisions_[k].condition;
      std::vector<Sample> &side = values[condition] != 0 ? sides_[k].yes : sides_[k].no;
      if (active[condition] && side.size() < most_pairs) side.push_back(sample);
    }
  }

  // Moves each number of each sample in turn, to the margin's extrapolated zero and a little beyond.
  void reach_other_side(std::size_t k) {
    NodeId const condition = decisions_[k].condition;
    std::vector<Sample> const from = sides_[k].yes.empty() ? sides_[k].no : sides_[k].yes;
    for (Sample const &sample : from)
      for (std::size_t i = 0; i < std::min(sample.inputs.size(), most_moved) && !sides_[k].are_met(); ++i) {
        Sample moved = sample;
        for (int turn = 0; turn < 3 && has_time(); ++turn) {
          double const here = moved.inputs[i], margin = margin_of(graph_, condition, values_at(moved)),
                       slope = slope_at(moved, i, condition, margin);
          // Steps beyond the zero first, then onto it, for a margin with a bend such as |x - 1|.
          if (slope == 0 || !move_to(moved, i, here - 1.0625 * margin / slope)) break;
          look_at(moved);
          if (!move_to(moved, i, here - margin / slope)) break;
          look_at(moved);
          if (sides_[k].are_met()) return;
        }
      }
  }

  // Difference quotient of the margin, by a step that changes it; 0 if no step does.
  double slope_at(Sample sample, std::size_t i, NodeId condition, double margin) {
    double const here = sample.inputs[i];
    for (double step = std::max(std::abs(here), 1.0) / 64; std::isfinite(here + step) && has_time(); step *= 0x1p20) {
      sample.inputs[i] = here + step;
      double const slope = (margin_of(graph_, condition, values_at(sample)) - margin) / step;
      if (slope != 0) return std::isfinite(slope) ? slope : 0;
    }
    return 0;
  }

  // Sets the number; returns whether it lies where samples are drawn.
  bool move_to(Sample &sample, std::size_t i, double number) const {
    std::optional<Range> const &range = ranges_[i];
    sample.inputs[i] = number;
    return std::isfinite(number) && (!range || (number >= range->low && number <= range->high));
  }

  // Halfway in each number, until none lies between.
  void bisect(NodeId condition, Sample yes, Sample no, std::vector<Sample> &found) {
    auto middle = [](std::vector<double> &a, std::vector<double> const &b) {
      for (std::size_t i = 0; i < a.size(); ++i) a[i] += (b[i] - a[i]) / 2;
    };
    for (int k = 0; k < halvings_; ++k) {
      Sample between = yes;
      middle(between.inputs, no.inputs);
      middle(between.parameters, no.parameters);
      if (between == yes || between == no) break;
      (values_at(between)[condition] != 0 ? yes : no) = between;
    }
    found.push_back(std::move(yes));
    found.push_back(std::move(no));
  }

  Graph const &graph_;
  SampleSource source_;
  int halvings_;
  std::vector<Decision> decisions_;
  std::vector<Sides> sides_;
  std::vector<std::optional<Range>> ranges_; // per input
  std::size_t evaluated_ = 0;                // nodes
};

} // namespace

Boundaries find_boundaries(Graph const &graph, std::uint64_t seed, double apart) {
  if (calls_program(graph)) return {};
  return BoundarySearch(graph, seed, apart).run();
}

} // namespace symreal
