// Printing of the operations of an expression, by their patterns.
#include "engine/emit/print/constant_paths.h"
#include "engine/emit/print/expression_printer.h"
#include "engine/emit/print/tables.h"
#include "engine/graph/opaque.h"

#include <fmt/format.h>
#include <symreal/integer_functions.h>

namespace symreal {

void ExpressionPrinter::print_element(Node const &node, std::string_view array, std::size_t index) {
  if (!is_wide(node.op)) return context_.append_element(text_, array, index);
  context_.emission.uses.kept_integer = true;
  std::string element;
  context_.append_element(element, array, index);
  text_ += fill(language_, language_.expressions.kept_integer, {{"element", element}});
}

// Whether the node combines two constant halves.
bool ExpressionPrinter::is_integer_constant(Node const &node) const {
  return node.op == Op::wide && this->node(node.operand[0]).is_constant() && this->node(node.operand[1]).is_constant();
}

void ExpressionPrinter::print_integer_constant(Node const &node) {
  std::uint64_t const value =
      integers::bits(evaluate(node.op, this->node(node.operand[0]).value(), this->node(node.operand[1]).value(), 0));
  ExpressionSyntax const &syntax = language_.expressions;
  text_ += fill(language_, value <= 0x7FFFFFFFu ? syntax.small_integer : syntax.large_integer,
                {{"value", std::to_string(value)},
                 {"signed", std::to_string(static_cast<std::int64_t>(value))},
                 {"hex", fmt::format("{:X}", value)}});
}

void ExpressionPrinter::print_operation(Node const &node, int binding) {
  OperationInfo const &operation = info(node.op);
  if (operation.form == Form::external) return print_external(node);
  int const precedence = context_.emission.spellings[node.op].precedence;
  if (precedence != 0 && precedence < binding) {
    text_ += '(';
    push(")");
  }
  if (operation.form == Form::local) context_.emission.uses.integer_functions.insert(operation.c);
  NodeId const hidden =
      context_.constant_paths.empty() ? no_node : hidden_operand(graph_, context_.constant_paths, node);
  std::array<Item, 3> operands;
  for (unsigned i = 0; i < operation.arity; ++i) {
    bool const decides = operation.has(flag::LOGICAL) || (operation.form == Form::select && i == 0);
    bool const is_integer = takes_wide(node.op, i);
    As const as = decides ? As::truth : is_integer ? As::itself : As::number;
    operands[i] = {.node = node.operand[i], .as = as};
  }
  convert_integers(operation, std::span(operands).first(operation.arity));
  push_pattern(node.op, std::span(operands).first(operation.arity), hidden);
}

// Pushes the comparison of `id`, as a number, with 0.
void ExpressionPrinter::push_comparison(Op op, NodeId id) {
  push_pattern(op, std::array{Item{.node = id, .as = As::number}, Item{.text = lasting(constant(language_, 0))}});
}

void ExpressionPrinter::push_pattern(Op op, std::span<Item const> operands, NodeId hidden) {
  context_.emission.uses.spelled[static_cast<std::size_t>(op)] = true;
  std::vector<Spellings::Piece> const &pieces = context_.emission.spellings[op].pieces;
  auto const operand_of = [&](Spellings::Piece const &piece) {
    Item operand = operands[static_cast<std::size_t>(piece.operand)];
    operand.binding = piece.binding;
    return operand;
  };
  std::size_t printed = 0; // most operands are printed at once
  for (; printed < pieces.size(); ++printed) {
    Spellings::Piece const &piece = pieces[printed];
    if (piece.operand < 0) {
      text_ += piece.text;
      continue;
    }
    Item const operand = operand_of(piece);
    if (operand.node == no_node || operand.node == hidden || !is_plain(operand)) break;
    print_itself(operand);
  }
  for (std::size_t i = pieces.size(); i-- > printed;) {
    if (pieces[i].operand < 0) {
      push(pieces[i].text);
      continue;
    }
    Item const &operand = operands[static_cast<std::size_t>(pieces[i].operand)];
    if (operand.node != no_node && operand.node == hidden)
      push_hidden(operand);
    else
      stack_.push_back(operand_of(pieces[i]));
  }
}

void ExpressionPrinter::push_hidden(Item const &operand) {
  context_.emission.uses.hidden = true;
  std::string_view const hidden = lasting(with_words(language_, language_.expressions.hidden));
  std::size_t const place = hidden.find("$x");
  push(hidden.substr(place + 2));
  stack_.push_back(operand);
  push(hidden.substr(0, place));
}

// Prints an element of a table, or of the array that holds the results of a call. Calls are statements of their own.
void ExpressionPrinter::print_external(Node const &node) {
  if (node.op == Op::returned) {
    text_ += context_.result_element(node.operand[0], result_of(graph_, node));
    return;
  }
  internal_check(node.op == Op::lookup || node.op == Op::lookup2);
  std::size_t const number = table_of(graph_, node);
  context_.emission.uses.tables.insert(number);
  std::vector<std::size_t> const &extents = graph_.tables[number].extents;
  auto const text = [&](std::size_t dimension) { return print_use(context_, node.operand[1 + dimension]); };
  auto const index = [&](std::size_t dimension) {
    return fill(language_, language_.expressions.table_index,
                {{"index", text(dimension)}, {"extent", std::to_string(extents[dimension])}});
  };
  std::string at = index(0);
  if (extents.size() == 2) at += "*" + std::to_string(extents[1]) + " + " + index(1);
  if (std::size_t const first = language_.expressions.first_index) at += " + " + std::to_string(first);
  text_ += fill(language_, language_.expressions.element, {{"array", table_name(language_, number)}, {"index", at}});
}

} // namespace symreal
