#include "engine/plan/reroll/sequence.h"

#include "engine/plan/schedule/dependences.h"

#include <algorithm>
#include <utility>

namespace symreal::reroll {

namespace {

Operation operation_of(Node const &node, NodeId id) {
  Operation result{id, node.op == Op::sub ? Op::add : node.op};
  for (NodeId operand : node.operand)
    if (operand != no_node) result.operands[result.count++] = {operand, false};
  result.operands[1].negated = node.op == Op::sub;
  result.may_exchange = result.op == Op::add || node.op == Op::mul;
  return result;
}

constexpr std::uint32_t least_family = 24; // products of one variable with constants, including duplicates
constexpr std::uint32_t near = 16;         // window size in operations

// Variable that an operation multiplies by a constant; no_node if it is another operation.
NodeId multiplied(Sequence const &sequence, Operation const &operation) {
  if (operation.op != Op::mul) return no_node;
  NodeId const a = operation.operands[0].node, b = operation.operands[1].node;
  bool const a_is_constant = sequence.array(a) == Array::values, b_is_constant = sequence.array(b) == Array::values;
  return a_is_constant == b_is_constant ? no_node : a_is_constant ? b : a;
}

// Per node: whether it is one of many products of one variable.
std::vector<char> families(Sequence const &sequence) {
  std::vector<std::uint32_t> members(sequence.graph->nodes.size(), 0);
  std::vector<char> is_member(sequence.graph->nodes.size(), 0);
  for (Operation const &operation : sequence.operations)
    if (NodeId const variable = multiplied(sequence, operation); variable != no_node) ++members[variable];
  for (Operation const &operation : sequence.operations) {
    NodeId const variable = multiplied(sequence, operation);
    is_member[operation.node] = variable != no_node && members[variable] >= least_family;
  }
  return is_member;
}

class ProductCopier {
public:
  ProductCopier(Sequence const &sequence, std::vector<char> is_member)
      : sequence_(sequence),
        is_member_(std::move(is_member)),
        next_(static_cast<NodeId>(sequence.graph->nodes.size())) {
    latest_.resize(next_, no_node);
  }

  bool copies_enough() {
    std::vector<std::uint32_t> place(next_, no_position); // per node, position of its latest duplicate
    for (Operation operation : sequence_.operations) {
      for (unsigned i = 0; i < operation.count; ++i) {
        NodeId &node = operation.operands[i].node;
        if (!is_member_[node]) continue;
        auto const here = static_cast<std::uint32_t>(operations_.size());
        if (here - place[node] > near) {
          operations_.push_back(sequence_.operations[sequence_.position[node]]);
          operations_.back().node = latest_[node] = next_++;
          copied_.push_back(node);
        }
        place[node] = here;
        node = latest_[node];
      }
      if (is_member_[operation.node]) {
        place[operation.node] = static_cast<std::uint32_t>(operations_.size());
        latest_[operation.node] = operation.node;
      }
      operations_.push_back(operation);
    }
    return copied_.size() >= least_family;
  }

  OwnProducts result() && {
    auto graph = std::make_unique<Graph>(*sequence_.graph);
    for (NodeId const node : copied_) {
      graph->nodes.push_back(graph->nodes[node]);
      if (!graph->node_location.empty()) graph->node_location.push_back(graph->node_location[node]);
      if (!graph->node_exact.empty()) graph->node_exact.push_back(graph->node_exact[node]);
      if (!graph->node_name.empty()) graph->node_name.push_back(graph->node_name[node]);
    }
    Sequence sequence{graph.get(), std::move(operations_), sequence_.position, sequence_.slot, sequence_.angle};
    for (auto *column : {&sequence.position, &sequence.slot, &sequence.angle}) column->resize(next_, no_slot);
    for (std::uint32_t at = 0; at < sequence.size(); ++at) {
      Operation const &operation = sequence.operations[at];
      sequence.position[operation.node] = at;
      for (unsigned i = 0; i < operation.count; ++i)
        graph->nodes[operation.node].operand[i] = operation.operands[i].node;
    }
    return {std::move(graph), std::move(sequence)};
  }

private:
  Sequence const &sequence_;
  std::vector<char> const is_member_;
  NodeId next_; // id of the next duplicate
  std::vector<NodeId> latest_, copied_ = {};
  std::vector<Operation> operations_;
};

} // namespace

Sequence sequence(Plan const &plan, FunctionKind kind, std::vector<NodeId> const &roots) {
  Graph const &graph = *plan.graph;
  std::vector<std::uint32_t> const none(graph.nodes.size(), no_slot);
  Sequence result{&graph,
                  {},
                  std::vector<std::uint32_t>(graph.nodes.size(), no_position),
                  reads_elements(kind) ? plan.constant_slot : none,
                  reads_elements(kind) && !plan.angles.element.empty() ? plan.angles.element : none};
  std::vector<char> const needed = needed_operations(plan, kind, roots);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (!needed[id]) continue;
    result.position[id] = static_cast<std::uint32_t>(result.operations.size());
    result.operations.push_back(operation_of(graph.nodes[id], static_cast<NodeId>(id)));
  }
  return result;
}

std::optional<OwnProducts> with_own_products(Sequence const &sequence) {
  std::vector<char> is_member = families(sequence);
  if (std::ranges::find(is_member, char{1}) == is_member.end()) return {};
  ProductCopier copier(sequence, std::move(is_member));
  if (!copier.copies_enough()) return {};
  return std::move(copier).result();
}

} // namespace symreal::reroll
