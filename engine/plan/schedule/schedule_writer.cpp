#include "engine/graph/graph_text.h"
#include "engine/plan/schedule/schedule_text.h"
#include "engine/support/number.h"

#include <ostream>
#include <sstream>

namespace symreal {

namespace {

class Writer {
public:
  Writer(std::ostream &out, Schedule const &plan) : out_(out), plan_(plan), number_(line_numbers(*plan.graph)) {}

  void write() {
    std::ostringstream graph;
    write_graph(graph, *plan_.graph);
    std::string const text = graph.str();
    out_ << "symreal-schedule 1\n" << text.substr(text.find('\n') + 1);
    write_function("preprocess", plan_.preprocess);
    for (std::size_t slot = 0; slot < plan_.preprocess.results.size(); ++slot)
      out_ << "store " << slot << ' ' << spell(plan_.preprocess, plan_.preprocess.results[slot]) << '\n';
    write_function("compute", plan_.compute);
  }

private:
  void write_function(char const *name, FunctionBody const &body) {
    out_ << "function " << name << '\n';
    for (std::size_t id = 1; id < body.regions.regions.size(); ++id) {
      out_ << "region " << id;
      for (Literal const &literal : body.regions.literals(static_cast<RegionId>(id)))
        out_ << (literal.holds ? " " : " !") << spell(body, literal.condition);
      out_ << '\n';
    }
    for (std::size_t gate = 0; gate < body.regions.gates.size(); ++gate) {
      out_ << "gate " << gate << (body.regions.gates[gate].empty() ? "" : " any");
      for (RegionId alternative : body.regions.gates[gate]) out_ << ' ' << alternative;
      out_ << '\n';
    }
    std::size_t check = 0, part = 0;
    for (std::size_t k = 0; k <= body.variables.size(); ++k) {
      for (; check < body.checks.size() && body.checks[check].before == k; ++check) out_ << "check " << check << '\n';
      for (; part < body.parts.size() && body.parts[part].end == k; ++part)
        out_ << "part " << body.parts[part].stage << " of " << plan_.threads << " threads\n";
      if (k == body.variables.size()) break;
      NodeId const id = body.variables[k];
      out_ << "set " << spell(body, id);
      if (body.region[k] != everywhere) out_ << " in " << body.region[k];
      out_ << (body.wanted_returns.contains(id) ? " returned\n" : "\n");
    }
  }

  std::string spell(FunctionBody const &body, NodeId id) const {
    if (body.regions.is_gate(id)) return "?" + std::to_string(id - body.regions.node_count);
    Node const &node = plan_.graph->nodes[id];
    return node.is_constant() ? shortest(node.value()) : "%" + std::to_string(number_[id]);
  }

  std::ostream &out_;
  Schedule const &plan_;
  std::vector<NodeId> number_;
};

} // namespace

void write_schedule(std::ostream &out, Schedule const &plan) { Writer(out, plan).write(); }

} // namespace symreal
