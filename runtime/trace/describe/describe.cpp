#include "runtime/trace/describe/describe.h"

#include "engine/graph/names.h"
#include "engine/support/number.h"
#include "runtime/trace/kernel/kernel.h"
#include "runtime/trace/nodes/externals.h"
#include "runtime/trace/nodes/pool.h"

#include <symreal/integer_functions.h>

#include <ostream>

namespace symreal {

namespace trace {

static constexpr int deepest = 4; // bounds the recursion, and the text for a reader

static std::string leaf_name(std::vector<Object> const &objects, std::uint32_t slot) {
  return element_name(objects, slot).value_or("input " + std::to_string(slot));
}

static std::string describe_external(Node const &node, std::string const *operands) {
  auto number = [&](std::size_t i) {
    return static_cast<std::size_t>(session().pool.nodes()[node.operand[i]].value());
  };
  if (node.op == Op::lookup || node.op == Op::lookup2) {
    std::string const text = session().externals.tables()[number(0)].name + "[" + operands[1] + "]";
    return node.op == Op::lookup ? text : text + "[" + operands[2] + "]";
  }
  if (is_call(node.op)) return session().externals.functions()[number(1)].name + "(...)";
  return node.op == Op::returned ? operands[0] : "...";
}

// Spelling in a program, without the parts that only generated code needs.
static std::string spelling(OperationInfo const &operation) {
  if (operation.op == Op::int32 || operation.op == Op::int64) return "trunc";
  if (operation.op == Op::wide_int || operation.op == Op::wide_value) return "(int64_t)";
  if (operation.op == Op::wide_uint || operation.op == Op::wide_uvalue) return "(uint64_t)";
  constexpr std::string_view wrap = "wrap_";
  if (operation.name.starts_with(wrap)) return "(" + std::string(operation.name.substr(wrap.size())) + "_t)";
  return std::string(operation.c);
}

static std::string describe_node(NodeId id, int depth) {
  Node const &node = session().pool.nodes()[id];
  if (node.is_constant()) return shortest(node.value());
  if (node.op == Op::input) return leaf_name(session().kernel.interface().inputs, node.slot());
  if (node.op == Op::parameter) return leaf_name(session().kernel.interface().parameters, node.slot());
  if (depth == deepest) return "...";
  OperationInfo const &operation = info(node.op);
  if (node.op == Op::wide) { // of two constants
    auto half = [&](std::size_t i) { return session().pool.nodes()[node.operand[i]].value(); };
    return std::to_string(integers::wide(half(0), half(1)));
  }
  if (node.op == Op::within_int32 || node.op == Op::within_uint32) return describe_node(node.operand[0], depth);
  std::string operands[3];
  for (unsigned i = 0; i < operation.arity; ++i) operands[i] = describe_node(node.operand[i], depth + 1);
  std::string text;
  if (node.op == Op::int_div)
    return (depth == 0 ? "" : "(") + operands[0] + " / " + operands[1] + (depth == 0 ? "" : ")");
  switch (operation.form) {
  case Form::infix: text = operands[0] + " " + std::string(operation.c) + " " + operands[1]; break;
  case Form::prefix: return std::string(operation.c) + operands[0];
  case Form::select: text = operands[0] + " ? " + operands[1] + " : " + operands[2]; break;
  case Form::external: return describe_external(node, operands);
  case Form::call:
  case Form::local:
  case Form::cast:
    text = spelling(operation) + "(" + operands[0];
    for (unsigned i = 1; i < operation.arity; ++i) text += ", " + operands[i];
    return text + ")";
  }
  return depth == 0 ? text : "(" + text + ")";
}

std::string describe(RealNumber number) {
  Pool &pool = session().pool;
  if (!number.is_node()) return shortest(number.plain());
  return pool.owns(number) ? describe_node(pool.node(number), 0) : "a value of another kernel";
}

std::string describe(Op op, RealNumber x, RealNumber y) {
  return describe(x) + " " + std::string(info(op).c) + " " + describe(y);
}

} // namespace trace

using trace::Pool;
using trace::session;

static Node view(RealNumber number) {
  Pool &pool = session().pool;
  return number.is_node() ? pool.nodes()[pool.node(number)] : Node::constant(number.plain());
}

SymbolicKind SymbolicExpr::kind() const noexcept {
  switch (view(number_).attribute) {
  case Attribute::constant: return SymbolicKind::constant;
  case Attribute::parametric: return SymbolicKind::parametric_constant;
  case Attribute::variable: break;
  }
  return SymbolicKind::variable;
}

bool SymbolicExpr::is_negative() const noexcept {
  Node node = view(number_);
  return node.is_constant() ? node.value() < 0 : node.op == Op::neg;
}

std::string SymbolicExpr::name() const {
  Node node = view(number_);
  return is_leaf(node.op) ? trace::describe(number_) : std::string(info(node.op).name);
}

void SymbolicExpr::print(std::ostream &out) const { out << trace::describe(number_); }

std::ostream &operator<<(std::ostream &out, SymbolicExpr const &expression) {
  expression.print(out);
  return out;
}

std::size_t SymbolicExprPool::size() noexcept { return session().pool.nodes().size(); }

} // namespace symreal
