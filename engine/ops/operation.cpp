#include "engine/ops/operation.h"

#include <symreal/integer_functions.h>

#include <cmath>
#include <unordered_map>

namespace symreal {

static_assert(
    [] {
      std::size_t row = static_cast<std::size_t>(Op::parameter) + 1;
      for (OperationInfo const &operation : detail::operation_table)
        if (static_cast<std::size_t>(operation.op) != row++) return false;
      return row == static_cast<std::size_t>(Op::count);
    }(),
    "the enum and the table run in parallel");

std::optional<Op> find_operation(std::string_view name) {
  static std::unordered_map<std::string_view, Op> const by_name = [] {
    std::unordered_map<std::string_view, Op> names;
    for (OperationInfo const &operation : detail::operation_table) names.emplace(operation.name, operation.op);
    return names;
  }();
  auto found = by_name.find(name);
  if (found == by_name.end()) return std::nullopt;
  return found->second;
}

[[noreturn]] static double opaque() {
  internal_failure("an opaque operation is not a function of its operands", __FILE__, __LINE__);
}

double evaluate(Op op, double x, double y, double z) {
  switch (op) {
#define OPERATION(id, arity, form, c, precedence, evaluate, ...)                                                       \
  case Op::id: return static_cast<double>(evaluate);
#include <symreal/operations.def>
#undef OPERATION
  case Op::constant:
  case Op::input:
  case Op::parameter:
  case Op::count: break;
  }
  internal_failure("a leaf has no evaluation", __FILE__, __LINE__);
}

CostModel const &usual_costs() {
  static CostModel const model = [] {
    CostModel made;
    for (OperationInfo const &row : operations()) made.work[static_cast<std::size_t>(row.op)] = row.cost;
    made.latency = made.work;
    return made;
  }();
  return model;
}

} // namespace symreal
