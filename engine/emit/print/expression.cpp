#include "engine/emit/print/expression.h"

#include "engine/emit/print/constant_paths.h"
#include "engine/graph/graph.h"
#include "engine/support/number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <forward_list>
#include <span>
#include <symreal/integer_functions.h>

namespace symreal {

FunctionContext::FunctionContext(Emission &emission, PlanFunction const &body)
    : emission(emission),
      body(body),
      spelling(emission, body),
      variable(body.regions.value_count(), no_slot),
      kept(body.regions.value_count(), no_slot),
      element_(emission.language, emission.language.expressions.element, {"array", "index"}) {
  bool const hides = !emission.language.expressions.hidden.empty() && emission.options.mode != FloatingPoint::fast;
  if (hides) constant_paths = constant_on_a_path(graph());
}

void FunctionContext::append_element(std::string &text, std::string_view array, std::size_t index) {
  arrays.insert(array);
  std::string number; // short enough to avoid allocation
  append_number(number, index + emission.language.expressions.first_index);
  element_.append_to(text, {array, number});
}

std::string FunctionContext::result_element(NodeId call, std::size_t result) {
  if (kept[call] != no_slot) {
    std::string text;
    append_element(text, "v", kept[call] + result);
    return text;
  }
  return symreal::element(emission.language, "r" + std::to_string(variable[call]), result);
}

namespace {

// Prints one expression, by the patterns of its operations.
class ExpressionPrinter {
public:
  using Item = ExpressionItem;
  using As = Item::As;

  // Appends to `text`.
  ExpressionPrinter(FunctionContext &context, std::string &text)
      : context_(context),
        language_(context.emission.language),
        graph_(context.graph()),
        stack_(context.items),
        others_(context.items.size()),
        text_(text) {}

  void print(Item item) {
    stack_.push_back(item);
    finish();
  }

  void print_condition(Literal literal) {
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

private:
  Node const &node(NodeId id) const { return graph_.nodes[id]; }
  bool is_variable(NodeId id) const { return context_.variable[id] != no_slot; }
  bool is_kept(NodeId id) const { return !is_variable(id) && context_.kept[id] != no_slot; }
  // Array element of a node computed by preprocess, or at the start of the function; nullopt for other nodes.
  std::optional<Element> precomputed(NodeId id) const {
    if (!reads_elements(context_.body.kind) || context_.is_gate(id)) return {};
    std::optional<Element> const element = context_.emission.plan.element(id);
    return element && element->array != Array::input ? element : std::nullopt;
  }
  bool is_precomputed(NodeId id) const { return precomputed(id).has_value(); }
  void print_variable(NodeId id) { context_.spelling.append_to(text_, context_.variable[id]); }

  void push(std::string_view text) { stack_.push_back({.text = text}); }
  // Text with the lifetime of the printer.
  std::string_view lasting(std::string text) { return lasting_.emplace_front(std::move(text)); }

  void finish() {
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
  bool spelled_out(NodeId id) const {
    return !context_.is_gate(id) && !is_leaf(node(id).op) && !is_variable(id) && context_.kept[id] == no_slot &&
           !is_precomputed(id);
  }

  bool is_truth(NodeId id) const { return context_.kind(id) == ValueKind::truth; }

  // Whether the node is read from an array, whose elements are numbers.
  bool is_element(Item const &item) const {
    bool const tells_apart = !language_.expressions.truth_as_number.empty();
    return !item.spelled_out && (is_kept(item.node) || (tells_apart && is_precomputed(item.node)));
  }

  // Whether print_itself prints the node completely: a number without an expression of its own.
  bool is_plain(Item const &item) const {
    return item.as != As::truth && !item.spelled_out && !spelled_out(item.node) && !is_truth(item.node);
  }

  // Whether the node is a truth value that the language treats as an integer.
  bool is_integer(NodeId id) const {
    bool const is_copied = !context_.copied.empty() && !context_.is_gate(id) && context_.copied[id] != no_slot;
    return language_.expressions.truth_as_number.empty() && is_truth(id) && !is_kept(id) && !is_copied &&
           !is_precomputed(id);
  }

  // Converts integer operands: on integers alone, the language would compute integers, with other quotients and no -0.
  void convert_integers(OperationInfo const &operation, std::span<Item> operands) const {
    bool const is_typed_by_operands =
        operation.form == Form::infix || operation.form == Form::prefix || operation.form == Form::select;
    if (!is_typed_by_operands || operation.has(flag::BOOLEAN)) return;
    auto const is_number = [](Item const &operand) { return operand.as == As::number; };
    auto const is_other = [&](Item const &operand) { return is_number(operand) && !is_integer(operand.node); };
    auto const first = std::ranges::find_if(operands, is_number);
    if (first != operands.end() && std::ranges::none_of(operands, is_other)) first->as = As::converted;
  }

  void print_node(Item const &item) {
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

  void print_itself(Item const &item) {
    NodeId const id = item.node;
    if (context_.is_gate(id))
      return is_variable(id) ? print_variable(id) : context_.append_element(text_, "v", context_.kept[id]);
    Node const &node = this->node(id);
    if (node.is_constant()) return print_constant(node.value(), item.binding);
    if (!item.spelled_out && is_variable(id)) return print_variable(id);
    if (!item.spelled_out && is_kept(id)) return print_element(id, "v", context_.kept[id]);
    if (!context_.copied.empty() && context_.copied[id] != no_slot) return print_element(id, "v", context_.copied[id]);
    if (std::optional<Element> const element = precomputed(id))
      return print_element(id, name_of(element->array), element->index);
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

  void print_constant(double value, int binding) {
    context_.emission.uses.not_finite = context_.emission.uses.not_finite || !std::isfinite(value);
    bool const parenthesised = std::signbit(value) && binding > language_.numbers.sign_binding;
    std::string const text = constant(language_, value);
    text_ += parenthesised ? "(" + text + ")" : text;
  }

  void print_element(NodeId id, std::string_view array, std::size_t index) {
    if (context_.kind(id) != ValueKind::u64) return context_.append_element(text_, array, index);
    context_.emission.uses.kept_integer = true;
    std::string element;
    context_.append_element(element, array, index);
    text_ += fill(language_, language_.expressions.kept_integer, {{"element", element}});
  }

  // Whether the node combines two constant halves.
  bool is_integer_constant(Node const &node) const {
    return node.op == Op::wide && this->node(node.operand[0]).is_constant() &&
           this->node(node.operand[1]).is_constant();
  }

  void print_integer_constant(Node const &node) {
    std::uint64_t const value =
        integers::bits(evaluate(node.op, this->node(node.operand[0]).value(), this->node(node.operand[1]).value(), 0));
    ExpressionSyntax const &syntax = language_.expressions;
    text_ += fill(language_, value <= 0x7FFFFFFFu ? syntax.small_integer : syntax.large_integer,
                  {{"value", std::to_string(value)},
                   {"signed", std::to_string(static_cast<std::int64_t>(value))},
                   {"hex", fmt::format("{:X}", value)}});
  }

  void print_operation(Node const &node, int binding) {
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
  void push_comparison(Op op, NodeId id) {
    push_pattern(op, std::array{Item{.node = id, .as = As::number}, Item{.text = lasting(constant(language_, 0))}});
  }

  void push_pattern(Op op, std::span<Item const> operands, NodeId hidden = no_node) {
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

  void push_hidden(Item const &operand) {
    context_.emission.uses.hidden = true;
    std::string_view const hidden = lasting(with_words(language_, language_.expressions.hidden));
    std::size_t const place = hidden.find("$x");
    push(hidden.substr(place + 2));
    stack_.push_back(operand);
    push(hidden.substr(0, place));
  }

  // Prints an element of a table, or of the array that holds the results of a call. Calls are statements of their own.
  void print_external(Node const &node) {
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
    text_ += fill(language_, language_.expressions.element,
                  {{"array", context_.emission.table_name(number)}, {"index", at}});
  }

  FunctionContext &context_;
  Language const &language_;
  Graph const &graph_;
  std::vector<Item> &stack_; // replaces recursion; items are pushed last first
  std::size_t others_;       // number of items of enclosing expressions
  std::string &text_;
  std::forward_list<std::string> lasting_;
};

} // namespace

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
