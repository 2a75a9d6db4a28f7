#include "engine/optimise/differentiate/rules.h"

#include "engine/graph/graph.h"

#include <algorithm>

namespace symreal {

namespace {

struct SlopeRule {
  Slope slope;
  Term term;
};

Slope slope_without_formula(OperationInfo const &row, std::size_t i) {
  if (row.has(flag::BOOLEAN) || (row.form == Form::select && i == 0)) return Slope::zero;
  if (row.op == Op::argument || is_call(row.op) || row.op == Op::returned) return Slope::unknown;
  bool const is_given = !row.derivative.empty();
  return is_given || row.has(flag::WIDE | flag::TAKES_WIDE | flag::OPAQUE) ? Slope::steps : Slope::unknown;
}

std::vector<SlopeRule> rules_of(OperationInfo const &row) {
  std::vector<SlopeRule> rules;
  std::string_view rest = row.derivative;
  for (std::size_t i = 0; i < row.arity; ++i) {
    std::size_t const end = std::min(rest.find(';'), rest.size());
    std::string_view const text = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (text.empty() || text == "0")
      rules.push_back({slope_without_formula(row, i), {Term::Kind::number}});
    else
      rules.push_back({Slope::formula, parse_term(text)});
  }
  internal_check(rest.empty());
  return rules;
}

SlopeRule const &rule_of(Op op, std::size_t i) {
  static std::vector<std::vector<SlopeRule>> const all = [] {
    std::vector<std::vector<SlopeRule>> made(static_cast<std::size_t>(Op::count));
    for (OperationInfo const &row : operations()) made[static_cast<std::size_t>(row.op)] = rules_of(row);
    return made;
  }();
  return all[static_cast<std::size_t>(op)].at(i);
}

bool has_steps(Term const &term) {
  if (term.kind != Term::Kind::operation) return false;
  for (std::size_t i = 0; i < term.operands.size(); ++i)
    if (slope_of(term.op, i) == Slope::steps && term.op != Op::copysign) return true;
  return std::ranges::any_of(term.operands, has_steps);
}

bool is_same(External const &a, External const &b) {
  return a.name == b.name && a.returned == b.returned && a.parameters == b.parameters && a.derivatives == b.derivatives;
}

External const &called(Graph const &graph, NodeId id) {
  return graph.externals[function_of(graph, graph.nodes[graph.nodes[id].operand[0]])];
}

} // namespace

Slope slope_of(Op op, std::size_t i) { return rule_of(op, i).slope; }

Term const &derivative_of(Op op, std::size_t i) {
  internal_check(slope_of(op, i) == Slope::formula);
  return rule_of(op, i).term;
}

bool jumps_between(Op op) {
  for (std::size_t i = 0; i < arity(op); ++i)
    if (slope_of(op, i) == Slope::formula && has_steps(derivative_of(op, i))) return true;
  return false;
}

void add_derivative_functions(Graph &graph) {
  for (std::size_t k = 0; k < graph.externals.size(); ++k)
    if (derivative_function(graph, k) == graph.externals.size())
      if (std::optional<External> derivative = graph.externals[k].derivative())
        graph.externals.push_back(std::move(*derivative));
}

std::size_t derivative_function(Graph const &graph, std::size_t function) {
  std::optional<External> const wanted = graph.externals[function].derivative();
  if (!wanted) return graph.externals.size();
  auto const found = std::ranges::find_if(graph.externals, [&](External const &one) { return is_same(one, *wanted); });
  return static_cast<std::size_t>(found - graph.externals.begin());
}

std::vector<NodeId> differentiable_arguments(Graph const &graph, NodeId id) {
  if (graph.nodes[id].op != Op::returned) return {};
  External const &external = called(graph, id);
  if (external.derivatives.empty()) return {};
  std::vector<NodeId> const all = arguments_of(graph, graph.nodes[graph.nodes[id].operand[0]].operand[0]);
  std::vector<NodeId> numbers;
  for (std::size_t const argument : external.number_arguments()) numbers.push_back(all[argument]);
  return numbers;
}

std::size_t first_partial(Graph const &graph, NodeId id) {
  return result_of(graph, graph.nodes[id]) * called(graph, id).number_arguments().size();
}

} // namespace symreal
