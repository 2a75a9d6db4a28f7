// Printing of the nodes of an expression, and the entry points.
#include "engine/emit/print/expression_printer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace symreal {

void ExpressionPrinter::print(Item item) {
  stack_.push_back(item);
  finish();
}

void ExpressionPrinter::print_condition(Literal literal) {
  auto [id, wanted] = literal;
  while (spelled_out(id) && node(id).op == Op::logical_not) {
    id = node(id).operand[0];
    wanted = !wanted;
  }
  if (!is_truth(id) || !(is_variable(id) || spelled_out(id))) { // a number
    push_comparison(wanted ? Op::ne : Op::eq, id);
    return finish();
  }
  if (!wanted && spelled_out(id) && (node(id).op == Op::eq || node(id).op == Op::ne)) {
    Node negated = node(id);
    negated.op = negated.op == Op::eq ? Op::ne : Op::eq;
    print_operation(negated, binding::loosest);
    return finish();
  }
  if (wanted) return print({.node = id});
  push_pattern(Op::logical_not, std::array{Item{.node = id}});
  finish();
}

void ExpressionPrinter::finish() {
  while (stack_.size() > others_) {
    Item const item = stack_.back();
    stack_.pop_back();
    if (item.node == no_node)
      text_ += item.text;
    else
      print_node(item);
  }
}

// Whether the node is printed as an expression, rather than as a variable or an array element.
bool ExpressionPrinter::spelled_out(NodeId id) const {
  return !context_.is_gate(id) && !is_leaf(node(id).op) && !is_variable(id) && context_.kept[id] == no_slot &&
         !is_precomputed(id);
}

bool ExpressionPrinter::is_truth(NodeId id) const {
  return context_.is_gate(id) || (!is_leaf(node(id).op) && info(node(id).op).has(flag::BOOLEAN));
}

// Whether the node is read from an array, whose elements are numbers.
bool ExpressionPrinter::is_element(Item const &item) const {
  bool const tells_apart = !language_.expressions.truth_as_number.empty();
  return !item.spelled_out && (is_kept(item.node) || (tells_apart && is_precomputed(item.node)));
}

// Whether print_itself prints the node completely: a number without an expression of its own.
bool ExpressionPrinter::is_plain(Item const &item) const {
  return item.as != As::truth && !item.spelled_out && !spelled_out(item.node) && !is_truth(item.node);
}

// Whether the node is a truth value that the language treats as an integer.
bool ExpressionPrinter::is_integer(NodeId id) const {
  bool const is_copied = !context_.copied.empty() && !context_.is_gate(id) && context_.copied[id] != no_slot;
  return language_.expressions.truth_as_number.empty() && is_truth(id) && !is_kept(id) && !is_copied &&
         !is_precomputed(id);
}

// Converts integer operands: on integers alone, the language would compute integers, with other quotients and no -0.
void ExpressionPrinter::convert_integers(OperationInfo const &operation, std::span<Item> operands) const {
  bool const is_typed_by_operands =
      operation.form == Form::infix || operation.form == Form::prefix || operation.form == Form::select;
  if (!is_typed_by_operands || operation.has(flag::BOOLEAN)) return;
  auto const is_number = [](Item const &operand) { return operand.as == As::number; };
  auto const is_other = [&](Item const &operand) { return is_number(operand) && !is_integer(operand.node); };
  auto const first = std::ranges::find_if(operands, is_number);
  if (first != operands.end() && std::ranges::none_of(operands, is_other)) first->as = As::converted;
}

void ExpressionPrinter::print_node(Item const &item) {
  bool const is_truth = this->is_truth(item.node) && !is_element(item);
  if (item.as == As::truth && !is_truth) {
    text_ += '(';
    push(")");
    return push_comparison(Op::ne, item.node);
  }
  if (item.as == As::converted && is_integer(item.node)) {
    text_.append("(").append(language_.number.name).append(")(");
    push(")");
    stack_.push_back({.node = item.node, .spelled_out = item.spelled_out});
    return;
  }
  bool const is_number = item.as == As::number || item.as == As::converted;
  if (!is_number || !is_truth || language_.expressions.truth_as_number.empty()) return print_itself(item);
  std::string_view const as_number = lasting(with_words(language_, language_.expressions.truth_as_number));
  std::size_t const place = as_number.find("$x");
  text_.append(as_number.substr(0, place));
  push(as_number.substr(place + 2));
  stack_.push_back({.node = item.node, .spelled_out = item.spelled_out});
}

void ExpressionPrinter::print_itself(Item const &item) {
  NodeId const id = item.node;
  if (context_.is_gate(id))
    return is_variable(id) ? print_variable(id) : context_.append_element(text_, "v", context_.kept[id]);
  Node const &node = this->node(id);
  if (node.is_constant()) return print_constant(node.value(), item.binding);
  if (!item.spelled_out && is_variable(id)) return print_variable(id);
  if (!item.spelled_out && is_kept(id)) return print_element(node, "v", context_.kept[id]);
  if (!context_.copied.empty() && context_.copied[id] != no_slot) return print_element(node, "v", context_.copied[id]);
  if (std::optional<Element> const element = precomputed(id))
    return print_element(node, name_of(element->array), element->index);
  if (node.op == Op::input && !context_.leaves.empty()) {
    text_ += context_.leaves[node.slot()];
    return;
  }
  if (is_leaf(node.op))
    return context_.append_element(text_, node.op == Op::input ? "input" : "parameters", node.slot());
  context_.spelled_out.push_back(id);
  context_.emission.uses.operations[static_cast<std::size_t>(node.op)] = true;
  if (is_integer_constant(node))
    print_integer_constant(node);
  else
    print_operation(node, item.binding);
}

void ExpressionPrinter::print_constant(double value, int binding) {
  context_.emission.uses.not_finite = context_.emission.uses.not_finite || !std::isfinite(value);
  bool const parenthesised = std::signbit(value) && binding > language_.numbers.sign_binding;
  std::string const text = constant(language_, value);
  text_ += parenthesised ? "(" + text + ")" : text;
}

void print_expression(FunctionContext &context, NodeId root, std::string &text) {
  ExpressionPrinter(context, text).print({.node = root, .spelled_out = true});
}

std::string print_condition(FunctionContext &context, Literal literal) {
  std::string text;
  ExpressionPrinter(context, text).print_condition(literal);
  return text;
}

void print_use(FunctionContext &context, NodeId node, std::string &text) {
  ExpressionPrinter(context, text).print({.node = node, .as = ExpressionPrinter::As::number});
}

std::string print_argument(FunctionContext &context, NodeId node) {
  std::string text;
  ExpressionPrinter(context, text).print({.node = node, .as = ExpressionPrinter::As::converted});
  return text;
}

std::string print_use(FunctionContext &context, NodeId node) {
  std::string text;
  print_use(context, node, text);
  return text;
}

} // namespace symreal
