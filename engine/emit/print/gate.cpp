#include "engine/emit/print/expression.h"

namespace symreal {

std::string print_gate(FunctionContext &context, NodeId gate) {
  auto const apply = [&](Op op, std::string const &x, std::string const &y) {
    context.emission.uses.spelled[static_cast<std::size_t>(op)] = true;
    return context.emission.spellings.apply(op, x, y);
  };
  auto const in_parentheses = [](std::string const &text) {
    return text.find(' ') == text.npos ? text : "(" + text + ")";
  };
  std::string any;
  for (RegionId alternative : context.body.regions.alternatives(gate)) {
    std::string all;
    for (Literal const &literal : context.body.regions.literals(alternative)) {
      std::string const one = in_parentheses(print_condition(context, literal));
      all = all.empty() ? one : apply(Op::logical_and, all, one);
    }
    if (all.empty()) return std::string(context.emission.language.expressions.yes);
    any = any.empty() ? in_parentheses(all) : apply(Op::logical_or, any, in_parentheses(all));
  }
  return any.empty() ? std::string(context.emission.language.expressions.yes) : any;
}

} // namespace symreal
