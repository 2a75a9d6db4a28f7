#include "engine/optimise/passes/snap.h"

#include "engine/graph/node_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace symreal {

namespace {

// Whether the constant is a literal: computed ones have 16 or 17 digits, handwritten ones fewer.
bool is_written(double value) {
  constexpr std::ptrdiff_t most_digits = 12;
  std::array<char, 32> text{};
  auto const end =
      std::to_chars(text.data(), text.data() + text.size(), std::fabs(value), std::chars_format::scientific);
  char const *const exponent = std::find(text.data(), end.ptr, 'e');
  return exponent - text.data() - 1 <= most_digits; // the decimal point excluded
}

std::optional<double> exact_near(double value, double distance) {
  for (double exact : {0.0, 1.0, -1.0, 0.5, -0.5})
    if (value != exact && std::fabs(value - exact) <= distance && !is_written(value)) return exact;
  return std::nullopt;
}

// Whether operand `i` of an operation may become this number.
bool may_become(Op op, std::size_t i, double exact) {
  switch (op) {
  case Op::add:
  case Op::sub:
  case Op::mul:
  case Op::neg:
  case Op::fma: return true;
  case Op::div: return i == 0 || exact != 0;
  default: return false;
  }
}

class Snapping {
public:
  Snapping(Graph const &graph, double distance) : graph_(graph), distance_(distance) {}

  Snapped run() {
    std::vector<char> const live = live_nodes(graph_);
    std::vector<NodeId> now(graph_.nodes.size());
    for (NodeId id = 0; id < graph_.nodes.size(); ++id) {
      Node node = graph_.nodes[id];
      if (is_leaf(node.op)) {
        now[id] = table_.intern(node);
        continue;
      }
      bool const stays = !live[id] || (!graph_.node_exact.empty() && graph_.node_exact[id]);
      for (std::size_t i = 0; i < arity(node.op); ++i) {
        NodeId const from = node.operand[i];
        std::optional<double> const exact = stays ? std::nullopt : exact_of(from);
        node.operand[i] = exact && may_become(node.op, i, *exact) ? use(from, *exact, id) : now[from];
      }
      now[id] = table_.intern(node);
    }
    std::vector<NodeId> results;
    for (NodeId result : graph_.results) {
      std::optional<double> const exact = exact_of(result);
      results.push_back(exact ? use(result, *exact, result) : now[result]);
    }
    result_.graph = without_nodes(graph_);
    result_.graph.nodes = table_.release();
    carry_over(graph_, now, result_.graph);
    result_.graph.results = std::move(results);
    return std::move(result_);
  }

private:
  std::optional<double> exact_of(NodeId id) const {
    return graph_.nodes[id].is_constant() ? exact_near(graph_.nodes[id].value(), distance_) : std::nullopt;
  }

  // Replaces constant `id` for node `user`.
  NodeId use(NodeId id, double exact, NodeId user) {
    auto const [known, is_new] = places_.try_emplace(id, result_.constants.size());
    if (is_new) result_.constants.push_back({graph_.nodes[id].value(), exact, 0, no_location});
    SnappedConstant &constant = result_.constants[known->second];
    ++constant.uses;
    if (constant.location == no_location && !graph_.node_location.empty())
      constant.location = graph_.node_location[user];
    return table_.constant(exact);
  }

  Graph const &graph_;
  double distance_;
  NodeTable table_;
  std::unordered_map<NodeId, std::size_t> places_; // indices into result_.constants
  Snapped result_;
};

} // namespace

Snapped snap_constants(Graph const &graph, double distance) { return Snapping(graph, distance).run(); }

} // namespace symreal
