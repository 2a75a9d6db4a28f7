#include "ops/operation.h"

#include "diagnostics/diagnostic.h"

#include <symreal/integer_functions.h>

#include <array>
#include <cmath>
#include <string>
#include <unordered_map>

namespace symreal {

using namespace flag;

static constexpr std::array table = {
#define OPERATION(id, arity, form, c, precedence, evaluate, derivative, cost, flags, domain, doc)                      \
  OperationInfo{Op::id, #id, arity, Form::form, c, precedence, derivative, cost, flags, Domain::domain, doc},
#include <symreal/operations.def>
#undef OPERATION
};

static_assert(
    [] {
      std::size_t row = static_cast<std::size_t>(Op::parameter) + 1;
      for (OperationInfo const &operation : table)
        if (static_cast<std::size_t>(operation.op) != row++) return false;
      return row == static_cast<std::size_t>(Op::count);
    }(),
    "the enum and the table run in parallel");

std::span<OperationInfo const> operations() { return table; }

OperationInfo const &info(Op op) {
  internal_check(!is_leaf(op));
  return table[static_cast<std::size_t>(op) - static_cast<std::size_t>(Op::parameter) - 1];
}

unsigned arity(Op op) { return is_leaf(op) ? 0 : info(op).arity; }

bool takes_wide(Op op, std::size_t i) {
  return info(op).has(flag::TAKES_WIDE) && !(info(op).form == Form::select && i == 0);
}

std::optional<Op> find_operation(std::string_view name) {
  static std::unordered_map<std::string_view, Op> const by_name = [] {
    std::unordered_map<std::string_view, Op> names;
    for (OperationInfo const &operation : table) names.emplace(operation.name, operation.op);
    return names;
  }();
  auto found = by_name.find(name);
  if (found == by_name.end()) return std::nullopt;
  return found->second;
}

[[noreturn]] static double opaque() {
  internal_failure("an opaque operation is no function of its operands", __FILE__, __LINE__);
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

} // namespace symreal
