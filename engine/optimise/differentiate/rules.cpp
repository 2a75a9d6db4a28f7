#include "engine/optimise/differentiate/rules.h"

#include <algorithm>
#include <optional>

namespace symreal {

namespace {

struct Rule {
  Slope slope;
  Term term;
};

Slope slope_without_formula(OperationInfo const &row, std::size_t i) {
  if (row.has(flag::BOOLEAN) || (row.form == Form::select && i == 0)) return Slope::zero;
  if (row.op == Op::argument || is_call(row.op) || row.op == Op::returned) return Slope::unknown;
  bool const is_given = !row.derivative.empty();
  return is_given || row.has(flag::WIDE | flag::TAKES_WIDE | flag::OPAQUE) ? Slope::steps : Slope::unknown;
}

std::vector<Rule> rules_of(OperationInfo const &row) {
  std::vector<Rule> rules;
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

Rule const &rule_of(Op op, std::size_t i) {
  static std::vector<std::vector<Rule>> const all = [] {
    std::vector<std::vector<Rule>> made(static_cast<std::size_t>(Op::count));
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

} // namespace symreal
