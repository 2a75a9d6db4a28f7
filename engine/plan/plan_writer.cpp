#include "engine/graph/graph_text.h"
#include "engine/plan/plan_text.h"
#include "engine/plan/schedule/schedule_text.h"
#include "engine/support/number.h"

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
  PlanWriter(std::ostream &out, Plan const &plan) : out_(out), plan_(plan), number_(line_numbers(plan.graph())) {}

  void write() {
    std::ostringstream text;
    write_schedule(text, plan_.schedule);
    out_ << text.str();
    if (plan_.schedule.angles.size() != 0) out_ << "angles\n";
    if (plan_.loops) {
      keep_shared_lines(text.str());
      for (auto const &[name, function] :
           {std::pair("preprocess", &plan_.loops->preprocess), std::pair("angles", &plan_.loops->computed_angles),
            std::pair("compute", &plan_.loops->compute)})
        if (*function) write_loops(name, **function);
    }
    if (plan_.lanes && plan_.lanes->compute) write_lanes(*plan_.lanes->compute);
  }

private:
  // Lines of the graph that the bodies of its loops repeat.
  void keep_shared_lines(std::string const &text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("location ") || line.starts_with("table ")) shared_.insert(line);
  }

  void write_loops(char const *name, LoopFunction const &function) {
    fmt::print(out_, "loops {} {} {} {}\nmemory {}\n", name, function.operations, function.in_loops, function.loops,
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
    if (leaf.kind == Leaf::Kind::values) {
      out_ << "leaf values" << (leaf.by_turn ? " by turn" : "");
      for (double const value : leaf.values) out_ << ' ' << shortest(value);
    } else {
      fmt::print(out_, "leaf {} {}", reroll::leaf_kind_names[static_cast<std::size_t>(leaf.kind)], spell(leaf.access));
    }
    if (leaf.kind == Leaf::Kind::carried) out_ << " next " << spell(body, number, leaf.next);
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
                 item.is_vector ? fmt::format("vector {}", item.id) : spell(plan_.graph(), number_, item.id));
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
      out_ << (is_elsewhere ? " ~" : " ") << spell(plan_.graph(), number_, node);
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
