#include "engine/analysis/figures/figures.h"
#include "engine/graph/graph_text.h"
#include "engine/graph/names.h"
#include "engine/support/number.h"
#include "tool/html/data.h"
#include "tool/html/groups.h"
#include "tool/html/packed.h"

namespace symreal::tool {
namespace {

std::string op_name(Op op) {
  return op == Op::input ? "input" : op == Op::parameter ? "parameter" : std::string(info(op).name);
}

// Distinct constants, in order of first use.
class Constants {
public:
  std::size_t number(double value) {
    auto const [entry, is_new] = numbers_.emplace(shortest(value), values_.size());
    if (is_new) values_.push_back(entry->first);
    return entry->second;
  }
  Json const &values() const { return values_; }

private:
  std::map<std::string, std::size_t> numbers_;
  Json values_ = Json::array();
};

} // namespace

std::vector<NodeId> shown_numbers(Graph const &graph) {
  std::vector<char> const live = live_nodes(graph);
  std::vector<NodeId> numbers(graph.nodes.size(), no_node);
  NodeId next = 0;
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (live[id] && !graph.nodes[id].is_constant()) numbers[id] = next++;
  return numbers;
}

Json node_data(Graph const &graph, Figures const &figures, Sources const &sources) {
  std::vector<NodeId> const shown = shown_numbers(graph), lines = line_numbers(graph);
  std::vector<std::string> const inputs = element_names(graph.inputs), parameters = element_names(graph.parameters);
  Groups groups(graph, sources);
  Constants constants;
  std::string ops;
  PackedNumbers operands, group, line, name;
  Json leaves = Json::array();
  std::uint64_t count = 0, last_line = 0;
  for (NodeId id = 0; id < graph.nodes.size(); ++id) {
    if (shown[id] == no_node) continue;
    Node const &node = graph.nodes[id];
    ops += static_cast<char>(node.op);
    group.add(groups.of(id));
    line.add(lines[id] - last_line);
    last_line = lines[id];
    name.add(id < graph.node_name.size() && graph.node_name[id] != no_name ? graph.node_name[id] + 1 : 0);
    if (is_leaf(node.op)) {
      leaves.push_back((node.op == Op::input ? inputs : parameters)[node.slot()]);
    } else {
      for (unsigned i = 0; i < arity(node.op); ++i) {
        Node const &operand = graph.nodes[node.operand[i]];
        operands.add(operand.is_constant() ? 2 * constants.number(operand.value()) + 1
                                           : 2 * std::uint64_t{count - shown[node.operand[i]]});
      }
    }
    ++count;
  }
  Json table = Json::object();
  for (OperationInfo const &row : operations())
    table[std::to_string(static_cast<unsigned>(row.op))] = {row.name, row.arity};
  for (Op leaf : {Op::input, Op::parameter}) table[std::to_string(static_cast<unsigned>(leaf))] = {op_name(leaf), 0};
  Json results = Json::array(), path = Json::array();
  std::vector<std::string> const outputs = element_names(graph.outputs);
  for (std::size_t slot = 0; slot < graph.results.size(); ++slot)
    if (shown[graph.results[slot]] != no_node) results.push_back({shown[graph.results[slot]], outputs[slot]});
  for (PathStep const &step : figures.critical_path) path.push_back(shown[step.node]);
  return {{"count", count},
          {"table", std::move(table)},
          {"ops", base64(ops)},
          {"operands", operands.text()},
          {"constants", constants.values()},
          {"leaves", std::move(leaves)},
          {"group", group.text()},
          {"groups", groups.data()},
          {"line", line.text()},
          {"name", name.text()},
          {"names", graph.names},
          {"results", std::move(results)},
          {"critical_path", std::move(path)}};
}

} // namespace symreal::tool
