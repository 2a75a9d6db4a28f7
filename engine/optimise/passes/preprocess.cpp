#include "engine/optimise/passes/min_cut.h"
#include "engine/optimise/passes/pass.h"

#include <unordered_map>

namespace symreal {

namespace {

// Parametric nodes that the variable part or an output uses directly, bare parameters included, since `compute` gets no
// parameters.
std::vector<char> needed_by_compute(Graph const &graph) {
  std::vector<char> const live = live_nodes(graph);
  std::vector<char> needed(graph.nodes.size(), 0);
  auto is_parametric = [&](NodeId id) { return graph.nodes[id].attribute == Attribute::parametric; };
  // An argument list cannot be stored, but its elements can.
  auto need = [&](NodeId operand) {
    for (; is_parametric(operand) && graph.nodes[operand].op == Op::argument; operand = graph.nodes[operand].operand[0])
      if (NodeId value = graph.nodes[operand].operand[1]; is_parametric(value)) needed[value] = 1;
    if (is_parametric(operand)) needed[operand] = 1;
  };
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (!live[id] || is_leaf(node.op) || node.attribute != Attribute::variable) continue;
    for (NodeId operand : node.operand)
      if (operand != no_node) need(operand);
  }
  for (NodeId root : graph.results)
    if (is_parametric(root)) needed[root] = 1;
  for (Guard const &guard : graph.guards)
    if (is_parametric(guard.condition)) needed[guard.condition] = 1;
  return needed;
}

// Rematerialization in `compute`: among the needed nodes and their operands, selects those cheaper to recompute than to
// load. A needed node costs a load; recomputing it saves the load, costs the operation, and needs its operands.
class Recomputation {
public:
  Recomputation(Graph const &graph, CostModel const &costs, std::vector<char> const &needed)
      : graph_(graph),
        costs_(costs),
        needed_(needed) {
    std::vector<NodeId> open;
    for (NodeId id = 0; id < graph.nodes.size(); ++id)
      if (needed[id]) open.push_back(id);
    for (std::size_t i = 0; i < open.size() && open.size() < most_nodes; ++i) {
      NodeId const id = open[i];
      if (!may_compute(id) || computed_.contains(id)) continue;
      Closure::Item const computed = closure_.add(costs.load - costs[graph.nodes[id].op]);
      computed_.emplace(id, computed);
      closure_.require(computed, item_of(id));
      for (NodeId operand : graph.nodes[id].operand) {
        if (operand == no_node || graph.nodes[operand].attribute == Attribute::constant) continue;
        closure_.require(computed, item_of(operand));
        open.push_back(operand);
      }
    }
  }

  // Nodes that `preprocess` stores.
  std::vector<char> stored() const {
    std::vector<char> const chosen = closure_.best();
    std::vector<char> stored = needed_;
    for (auto const &[id, item] : item_)
      if (chosen[item]) stored[id] = 1;
    for (auto const &[id, item] : computed_)
      if (chosen[item]) stored[id] = 0;
    return stored;
  }

private:
  static constexpr std::size_t most_nodes = 100'000;

  bool may_compute(NodeId id) const {
    using namespace flag;
    Op const op = graph_.nodes[id].op;
    return !is_leaf(op) && !info(op).has(OPAQUE | STRUCTURE | EFFECT | WIDE | TAKES_WIDE) && costs_[op] < costs_.load;
  }
  Closure::Item item_of(NodeId id) {
    auto const [known, is_new] = item_.try_emplace(id);
    if (is_new) known->second = closure_.add(needed_[id] ? 0 : -costs_.load);
    return known->second;
  }

  Graph const &graph_;
  CostModel const &costs_;
  std::vector<char> const &needed_;
  Closure closure_;
  std::unordered_map<NodeId, Closure::Item> item_, computed_; // items: the node is needed; `compute` recomputes it
};

} // namespace

// Boundary between `preprocess` and `compute`: each value that crosses it takes a slot of `constants`, so few should.
// Parametric nodes run in `preprocess`; `compute` recomputes those that depend on stored values alone if that is
// cheaper than a load.
Graph pass_preprocess(Graph graph, PassSettings const &settings) {
  std::vector<char> const needed = needed_by_compute(graph);
  std::vector<char> const stored = Recomputation(graph, settings.costs, needed).stored();
  graph.precomputed.clear();
  for (std::size_t id = 0; id < stored.size(); ++id)
    if (stored[id]) graph.precomputed.push_back(static_cast<NodeId>(id));
  return graph;
}

} // namespace symreal
