#include "engine/plan/reroll/check.h"

#include "engine/plan/reroll/roles.h"
#include "engine/plan/schedule/numbering.h"

#include <fmt/format.h>

namespace symreal::reroll {

namespace {

using Value = NumberedValue;

class Run {
public:
  Run(Sequence const &sequence, LoopFunction const &function, std::size_t result_count, bool zeros_have_signs)
      : sequence_(sequence),
        numbering_(zeros_have_signs),
        memory_(function.memory),
        results_(result_count) {}

  std::string steps(std::vector<LoopStep> const &steps) {
    for (LoopStep const &step : steps) {
      std::vector<Value> carried(step.leaves.size());
      for (std::uint32_t k = 0; k < step.count && difference_.empty(); ++k) iteration(step, k, carried);
    }
    return difference_;
  }

  void mirrors(std::vector<Mirror> const &mirrors) {
    for (Mirror const &mirror : mirrors)
      for_each_copy(mirror, [&](std::uint32_t to, std::uint32_t from) { results_[to] = results_[from]; });
  }

  std::string compare(std::vector<NodeId> const &stored, std::vector<NodeId> const &checked,
                      std::vector<std::uint32_t> const &checks) {
    std::vector<Value> const values = values_of_graph();
    for (std::size_t slot = 0; slot < stored.size(); ++slot)
      if (!results_[slot].is_known() || results_[slot] != values[stored[slot]])
        return fmt::format("result {} is another value", slot);
    if (checked.size() != checks.size()) return "a guard is not checked";
    for (std::size_t k = 0; k < checked.size(); ++k)
      if (memory_[checks[k]].number != values[checked[k]].number) // up to sign: only zero matters
        return fmt::format("guard {} has another condition", k);
    return {};
  }

private:
  void iteration(LoopStep const &step, std::uint32_t k, std::vector<Value> &carried) {
    Graph const &body = step.body;
    std::vector<Value> values(body.nodes.size());
    for (std::size_t id = 0; id < body.nodes.size(); ++id) {
      Node const &node = body.nodes[id];
      if (node.op == Op::input)
        values[id] = leaf(step, step.leaves[node.slot()], k, carried[node.slot()]);
      else if (node.is_constant())
        values[id] = numbering_.constant(node.value());
      else
        values[id] = operation(node, values);
      if (!values[id].is_known()) difference_ = fmt::format("iteration {} reads a value before it is computed", k);
    }
    for (Store const &store : step.stores) {
      std::vector<Value> &array = store.is_result ? results_ : memory_;
      has_results_ = has_results_ || store.is_result;
      array.at(store.access.at(k)) = values[store.value];
    }
    for (std::size_t slot = 0; slot < step.leaves.size(); ++slot)
      if (step.leaves[slot].is_carried) carried[slot] = values[step.leaves[slot].next];
  }

  Value leaf(LoopStep const &step, Leaf const &leaf, std::uint32_t k, Value const &carried) {
    if (has_results_ && is_argument(leaf.array)) difference_ = "an input is read after a result is stored";
    if (leaf.array == Array::values) return numbering_.constant(value_at(leaf, k, step.nest));
    if (leaf.array != Array::memory)
      return numbering_.element(static_cast<std::uint32_t>(leaf.array), leaf.access.at(k));
    return leaf.is_carried && k != 0 ? carried : memory_.at(leaf.access.at(k));
  }

  Value operation(Node const &node, std::vector<Value> const &values) {
    std::array<Value, 3> operands;
    for (std::size_t i = 0; i < arity(node.op); ++i) operands[i] = values[node.operand[i]];
    return numbering_.operation(node.op, operands);
  }

  std::vector<Value> values_of_graph() {
    Graph const &graph = *sequence_.graph;
    std::vector<Value> values(graph.nodes.size());
    for (NodeId id = 0; id < graph.nodes.size(); ++id) {
      Node const &node = graph.nodes[id];
      Array const source = sequence_.array(id);
      if (source == Array::memory)
        values[id] = operation(node, values);
      else if (source == Array::values)
        values[id] = numbering_.constant(node.value());
      else if (source != Array::input || is_leaf(node.op))
        values[id] = numbering_.element(static_cast<std::uint32_t>(source), sequence_.element(id));
    }
    return values;
  }

  Sequence const &sequence_;
  Numbering numbering_;
  std::vector<Value> memory_, results_;
  bool has_results_ = false;
  std::string difference_;
};

} // namespace

std::string find_difference(Sequence const &sequence, LoopFunction const &function, std::vector<NodeId> const &stored,
                            std::vector<NodeId> const &checked, bool zeros_have_signs) {
  Run run(sequence, function, stored.size(), zeros_have_signs);
  if (std::string difference = run.steps(function.steps); !difference.empty()) return difference;
  run.mirrors(function.mirrors);
  return run.compare(stored, checked, function.checks);
}

} // namespace symreal::reroll
