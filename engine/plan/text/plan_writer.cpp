#include "engine/graph/graph_text.h"
#include "engine/plan/text/plan_text.h"
#include "engine/support/number.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>
#include <ostream>
#include <set>
#include <sstream>

namespace symreal {

namespace {

using reroll::Access, reroll::Leaf, reroll::LoopFunction, reroll::LoopStep;

class PlanWriter {
public:
  PlanWriter(std::ostream &out, Plan const &plan) : out_(out), plan_(plan), number_(line_numbers(*plan.graph)) {}

  void write() {
    std::ostringstream graph;
    write_graph(graph, *plan_.graph);
    std::string const text = graph.str();
    keep_shared_lines(text);
    out_ << "symreal-plan 1\n" << text.substr(text.find('\n') + 1);
    for (PlanFunction const &function : plan_.functions) write_function(function);
  }

private:
  void write_function(PlanFunction const &function) {
    fmt::print(out_, "function {}\n", info(function.kind).name);
    write_regions(function);
    if (function.kind == FunctionKind::compute) write_angles();
    write_statements(function);
    if (info(function.kind).fills != Array::output)
      for (std::size_t slot = 0; slot < function.results.size(); ++slot)
        fmt::print(out_, "store {} {}\n", slot, spell(function, function.results[slot]));
    if (function.loops) write_loops(*function.loops);
    if (function.lanes) write_lanes(*function.lanes);
  }

  void write_regions(PlanFunction const &function) {
    for (std::size_t id = 1; id < function.regions.regions.size(); ++id) {
      out_ << "region " << id;
      for (Literal const &literal : function.regions.literals(static_cast<RegionId>(id)))
        out_ << (literal.holds ? " " : " !") << spell(function, literal.condition);
      out_ << '\n';
    }
    for (std::size_t gate = 0; gate < function.regions.gates.size(); ++gate) {
      out_ << "gate " << gate << (function.regions.gates[gate].empty() ? "" : " any");
      for (RegionId alternative : function.regions.gates[gate]) out_ << ' ' << alternative;
      out_ << '\n';
    }
  }

  void write_angles() {
    std::vector<std::pair<std::uint32_t, NodeId>> elements;
    for (NodeId id = 0; id < plan_.angles.element.size(); ++id)
      if (plan_.angles.element[id] != no_slot) elements.emplace_back(plan_.angles.element[id], id);
    std::ranges::sort(elements);
    for (auto const &[element, id] : elements)
      fmt::print(out_, "{} {} {}\n", info(plan_.graph->nodes[id].op).name, element, spell(*plan_.graph, number_, id));
  }

  void write_statements(PlanFunction const &function) {
    std::size_t check = 0, part = 0;
    for (std::size_t k = 0; k <= function.variables.size(); ++k) {
      for (; check < function.checks.size() && function.checks[check].before == k; ++check)
        out_ << "check " << check << '\n';
      for (; part < function.parts.size() && function.parts[part].end == k; ++part)
        out_ << "part " << function.parts[part].stage << " of " << plan_.threads << " threads\n";
      if (k == function.variables.size()) break;
      NodeId const id = function.variables[k];
      out_ << "set " << spell(function, id) << ' ' << name_of(plan_.kind(function, id));
      if (function.region[k] != everywhere) out_ << " in " << function.region[k];
      out_ << (function.wanted_returns.contains(id) ? " returned\n" : "\n");
    }
  }

  std::string spell(PlanFunction const &function, NodeId id) const {
    if (function.regions.is_gate(id)) return "?" + std::to_string(id - function.regions.node_count);
    return spell(*plan_.graph, number_, id);
  }

  // Lines of the graph that the bodies of its loops repeat.
  void keep_shared_lines(std::string const &text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("location ") || line.starts_with("table ")) shared_.insert(line);
  }

  void write_loops(LoopFunction const &function) {
    fmt::print(out_, "loops {} {} {}\nmemory {}\n", function.operations, function.in_loops, function.loops,
               function.memory);
    for (LoopStep const &step : function.steps) write_step(step);
    for (reroll::Mirror const &mirror : function.mirrors)
      fmt::print(out_, "mirror {} {} from {}\n", mirror.first, mirror.rows, mirror.from_above ? "above" : "below");
    for (std::uint32_t const element : function.checks) fmt::print(out_, "check {}\n", element);
  }

  void write_step(LoopStep const &step) {
    std::vector<NodeId> const number = line_numbers(step.body);
    fmt::print(out_, "step {}\n", step.count);
    if (step.nest) fmt::print(out_, "nest {} {} {}\n", step.nest->turns, step.nest->inner, step.nest->growth);
    for (Leaf const &leaf : step.leaves) write_leaf(leaf, step.body, number);
    std::ostringstream body;
    write_graph(body, step.body);
    std::istringstream lines(body.str());
    std::string line;
    std::getline(lines, line); // the head
    out_ << "body\n";
    while (std::getline(lines, line))
      if (!shared_.contains(line)) out_ << line << '\n';
    out_ << "end\n";
    for (reroll::Store const &store : step.stores)
      fmt::print(out_, "store {} {}\n", store.is_result ? "output" : "memory", spell(store.access));
  }

  void write_leaf(Leaf const &leaf, Graph const &body, std::vector<NodeId> const &number) {
    if (leaf.array == Array::values) {
      out_ << "leaf values" << (leaf.by_turn ? " by turn" : "");
      for (double const value : leaf.values) out_ << ' ' << shortest(value);
    } else {
      fmt::print(out_, "leaf {} {}", leaf.is_carried ? "carried" : name_of(leaf.array), spell(leaf.access));
    }
    if (leaf.is_carried) out_ << " next " << spell(body, number, leaf.next);
    out_ << '\n';
  }

  static std::string spell(Access const &access) {
    return access.is_listed() ? fmt::format("of {}", fmt::join(access.elements, " "))
                              : fmt::format("{} {}", access.first, access.step);
  }

  static std::string spell(Graph const &graph, std::vector<NodeId> const &number, NodeId id) {
    Node const &node = graph.nodes[id];
    return node.is_constant() ? shortest(node.value()) : "%" + std::to_string(number[id]);
  }

  void write_lanes(lanes::LaneFunction const &function) {
    fmt::print(out_, "lanes {} {} {}\n", function.width, function.operations, function.in_lanes);
    for (lanes::VectorId id = 0; id < function.vectors.size(); ++id) write_vector(function, id);
    for (lanes::Item const &item : function.order)
      fmt::print(out_, "compute {}\n",
                 item.is_vector ? fmt::format("vector {}", item.id) : spell(*plan_.graph, number_, item.id));
    for (lanes::Store const &store : function.stores)
      fmt::print(out_, "store vector {} at {}\n", store.vector, store.first);
  }

  void write_vector(lanes::LaneFunction const &function, lanes::VectorId id) {
    using Form = lanes::Vector::Form;
    lanes::Vector const &vector = function.vectors[id];
    out_ << "vector "
         << (vector.form == Form::operation ? info(vector.op).name
                                            : lanes::form_names[static_cast<std::size_t>(vector.form)]);
    if (vector.form == Form::load) fmt::print(out_, " {} {}", name_of(vector.array), vector.first);
    for (lanes::VectorId const operand : vector.operand)
      if (operand != lanes::no_vector) fmt::print(out_, " {}", operand);
    if (!vector.subtracts.empty()) {
      out_ << " subtracts";
      for (char const subtracts : vector.subtracts) out_ << (subtracts ? " 1" : " 0");
    }
    if (vector.form == Form::shuffle) fmt::print(out_, " takes {}", fmt::join(vector.from, " "));
    out_ << " :";
    for (std::uint32_t lane = 0; lane < vector.nodes.size(); ++lane) {
      NodeId const node = vector.nodes[lane];
      if (node == no_node) {
        out_ << " -";
        continue;
      }
      lanes::Lane const &own = function.lane[node];
      bool const is_elsewhere = vector.form == Form::operation && (own.vector != id || own.lane != lane);
      out_ << (is_elsewhere ? " ~" : " ") << spell(*plan_.graph, number_, node);
    }
    out_ << '\n';
  }

  std::ostream &out_;
  Plan const &plan_;
  std::vector<NodeId> number_;
  std::set<std::string> shared_;
};

} // namespace

void write_plan(std::ostream &out, Plan const &plan) { PlanWriter(out, plan).write(); }

} // namespace symreal
