// Descriptions, evaluation and costs of the operations, derived from their table (include/symreal/operations.def). The
// enum is in include/symreal/op.h, since symbolic programs need it.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <symreal/op.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace symreal {

enum class Form : std::uint8_t { infix, prefix, call, cast, select, local, external };
enum class Domain : std::uint8_t { any, positive, unit, above_one, integer };

struct OperationInfo {
  Op op;
  std::string_view name;
  unsigned arity;
  Form form;
  std::string_view c;
  int precedence;
  std::string_view derivative;
  int cost;
  unsigned flags;
  Domain domain;
  std::string_view doc;

  constexpr bool has(unsigned flag) const { return (flags & flag) != 0; }
};

namespace flag {
inline constexpr unsigned COMMUTATIVE = 1, ROUNDED = 2, ZERO_SIGN = 4, BOOLEAN = 8, LOGICAL = 16, QUIET = 32,
                          OPAQUE = 64, STRUCTURE = 128, EFFECT = 256, MONOTONE = 512, WIDE = 1024, TAKES_WIDE = 2048,
                          ERROR = 4096;
}

namespace detail {
using namespace flag;
// In the header, since passes look up the row of every node of a graph.
inline constexpr std::array operation_table = {
#define OPERATION(id, arity, form, c, precedence, evaluate, derivative, cost, flags, domain, doc)                      \
  OperationInfo{Op::id, #id, arity, Form::form, c, precedence, derivative, cost, flags, Domain::domain, doc},
#include <symreal/operations.def>
#undef OPERATION
};
} // namespace detail

// All operations in the order of the table.
inline std::span<OperationInfo const> operations() { return detail::operation_table; }

inline bool is_leaf(Op op) { return op <= Op::parameter; }
// The row of an operation, which must not be a leaf.
inline OperationInfo const &info(Op op) {
  internal_check(!is_leaf(op));
  return detail::operation_table[static_cast<std::size_t>(op) - static_cast<std::size_t>(Op::parameter) - 1];
}
inline unsigned arity(Op op) { return is_leaf(op) ? 0 : info(op).arity; }
// Whether the operation yields a 64-bit integer, whose bits a node's value holds.
inline bool is_wide(Op op) { return !is_leaf(op) && info(op).has(flag::WIDE); }
// Whether operand `i` must be a 64-bit integer.
inline bool takes_wide(Op op, std::size_t i) {
  return info(op).has(flag::TAKES_WIDE) && !(info(op).form == Form::select && i == 0);
}
inline bool is_call(Op op) { return op == Op::call || op == Op::call_in_order; }
std::optional<Op> find_operation(std::string_view name);

// Reference semantics. Unused operands are ignored. Truth values are 0 and 1. OPAQUE operations are excluded:
// graph/evaluate.h evaluates them.
double evaluate(Op op, double x, double y, double z);

// Operations whose result is one of the operands, up to its sign.
inline bool hands_on(Op op) {
  switch (op) {
  case Op::select:
  case Op::fmin:
  case Op::fmax:
  case Op::neg:
  case Op::abs:
  case Op::copysign: return true;
  default: return false;
  }
}

// Order relations of two numbers, as sets. A comparison holds for a subset of them.
namespace relation {
enum Of : unsigned { less = 1, equal = 2, greater = 4, unordered = 8, any = 15 }; // unordered: one of them is NaN

// Relations for which the comparison holds; the empty set if `op` is not a comparison of numbers.
inline unsigned held_by(Op op) {
  switch (op) {
  case Op::lt: return less;
  case Op::le: return less | equal;
  case Op::gt: return greater;
  case Op::ge: return greater | equal;
  case Op::eq: return equal;
  case Op::ne: return less | greater | unordered;
  default: return 0;
  }
}

// The relations with exchanged operands.
inline unsigned mirrored(unsigned set) {
  return (set & (equal | unordered)) | (set & less ? greater : 0u) | (set & greater ? less : 0u);
}
} // namespace relation

// Cost model of operations, which selects the cheaper of two ways to compute a value. Costs in additions; leaves are
// free.
struct CostModel {
  using Costs = std::array<double, static_cast<std::size_t>(Op::count)>;

  Costs work{};    // throughput cost: each of many independent operations
  Costs latency{}; // from the operands to the result
  double load = 1; // work of reading a number that preprocess stored

  double operator[](Op op) const { return work[static_cast<std::size_t>(op)]; }
  double latency_of(Op op) const { return latency[static_cast<std::size_t>(op)]; }
};

// Costs from column `cost` of the operation table; a load costs as much as an addition.
CostModel const &usual_costs();

} // namespace symreal
