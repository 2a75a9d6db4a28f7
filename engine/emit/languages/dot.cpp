#include "engine/emit/languages/drawn.h"
#include "engine/emit/print/banner.h"
#include "engine/emit/print/emission.h"
#include "engine/graph/names.h"

#include <fmt/format.h>

namespace symreal {

namespace {

class GraphPrinter {
public:
  explicit GraphPrinter(Emission const &emission)
      : emission_(emission),
        graph_(emission.graph()),
        live_(live_nodes(graph_)),
        needs_input_(live_.size(), 0) {
    for (NodeId id = 0; id < graph_.nodes.size(); ++id) {
      Node const &node = graph_.nodes[id];
      if (node.op == Op::input) needs_input_[id] = 1;
      if (is_leaf(node.op)) continue;
      for (unsigned k = 0; k < arity(node.op); ++k) needs_input_[id] |= needs_input_[node.operand[k]];
    }
  }

  std::string print() {
    std::string text = fmt::format("\ndigraph {} {{\n  node [fontsize=10];\n", quoted(graph_.kernel));
    text += leaves(Op::input, element_names(graph_.inputs)) + leaves(Op::parameter, element_names(graph_.parameters));
    text += cluster("preprocess", false) + cluster("compute", true);
    std::vector<std::string> const outputs = element_names(graph_.outputs);
    for (std::size_t k = 0; k < graph_.results.size(); ++k)
      text += fmt::format("  o{} [shape=box, label={}];\n", k, quoted(outputs[k])) +
              edge(graph_.results[k], fmt::format("o{}", k));
    for (std::size_t k = 0; k < graph_.guards.size(); ++k)
      text += fmt::format("  g{} [shape=octagon, label={}];\n", k + 1, quoted(fmt::format("guard {}", k + 1))) +
              edge(graph_.guards[k].condition, fmt::format("g{}", k + 1));
    return text + "}\n";
  }

private:
  std::string quoted(std::string const &text) const { return literal(emission_.language, text); }

  // Nodes of inputs or parameters; unused ones are dashed.
  std::string leaves(Op op, std::vector<std::string> const &names) const {
    std::string text;
    std::vector<char> is_drawn(names.size(), 0);
    for (NodeId id = 0; id < graph_.nodes.size(); ++id)
      if (live_[id] && graph_.nodes[id].op == op) {
        text += fmt::format("  n{} [shape=box, label={}];\n", id, quoted(names[graph_.nodes[id].slot()]));
        is_drawn[graph_.nodes[id].slot()] = 1;
      }
    for (std::size_t slot = 0; slot < names.size(); ++slot)
      if (!is_drawn[slot])
        text += fmt::format("  {}{} [shape=box, style=dashed, label={}];\n", op == Op::input ? "input" : "parameter",
                            slot, quoted(names[slot]));
    return text;
  }

  // Constants are drawn once per use.
  std::string edge(NodeId from, std::string const &to) {
    if (!graph_.nodes[from].is_constant()) return fmt::format("  n{} -> {};\n", from, to);
    ++constants_;
    return fmt::format("  c{0} [shape=plaintext, label=\"{1}\"];\n  c{0} -> {2};\n", constants_,
                       constant(emission_.language, graph_.nodes[from].value()), to);
  }

  std::string label(NodeId id) const {
    std::string const operation(info(graph_.nodes[id].op).name);
    bool const is_named = !graph_.node_name.empty() && graph_.node_name[id] != no_name;
    return quoted(is_named ? graph_.names[graph_.node_name[id]] + ": " + operation : operation);
  }

  std::string cluster(std::string const &name, bool needs_input) {
    std::string nodes, edges;
    for (NodeId id = 0; id < graph_.nodes.size(); ++id) {
      Node const &node = graph_.nodes[id];
      if (!live_[id] || is_leaf(node.op) || (needs_input_[id] != 0) != needs_input) continue;
      nodes += fmt::format("    n{} [label={}];\n", id, label(id));
      for (unsigned k = 0; k < arity(node.op); ++k) edges += edge(node.operand[k], fmt::format("n{}", id));
    }
    if (nodes.empty()) return {};
    return fmt::format("  subgraph cluster_{0} {{\n    label=\"{0}\";\n{1}  }}\n{2}", name, nodes, edges);
  }

  Emission const &emission_;
  Graph const &graph_;
  std::vector<char> live_, needs_input_;
  std::size_t constants_ = 0;
};

} // namespace

std::string dot_file(Emission const &emission) { return banner(emission) + GraphPrinter(emission).print(); }

} // namespace symreal
