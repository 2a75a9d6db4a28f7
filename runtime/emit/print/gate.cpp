#include "emit/print/expression.h"

namespace symreal {

std::string print_gate(FunctionContext &context, NodeId gate) {
  Spellings const &spellings = context.emission.spellings;
  auto const in_parentheses = [](std::string const &text) {
    return text.find(' ') == text.npos ? text : "(" + text + ")";
  };
  std::string any;
  for (RegionId alternative : context.body.regions.alternatives(gate)) {
    std::string all;
    for (Literal const &literal : context.body.regions.literals(alternative)) {
      std::string const one = in_parentheses(print_condition(context, literal));
      all = all.empty() ? one : spellings.apply(Op::logical_and, all, one);
    }
    if (all.empty()) return std::string(context.emission.language.expressions.yes);
    any = any.empty() ? in_parentheses(all) : spellings.apply(Op::logical_or, any, in_parentheses(all));
  }
  return any.empty() ? std::string(context.emission.language.expressions.yes) : any;
}

} // namespace symreal
