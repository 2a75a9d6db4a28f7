#include "emit/print/expression.h"

#include "emit/print/constant_paths.h"
#include "emit/print/integers.h"
#include "graph/opaque.h"
#include "support/number.h"

#include <symreal/integer_functions.h>

#include <cmath>

namespace symreal {

std::string c_constant(double value) {
  if (std::isnan(value)) return std::signbit(value) ? "-NAN" : "NAN";
  if (std::isinf(value)) return value < 0 ? "-INFINITY" : "INFINITY";
  std::string text = shortest(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

namespace {

constexpr int loosest = 0, prefix_operand = 15, additive = 12, unary = 14, conditional_operand = 4;

// What is still to be printed: text, or a node that needs parentheses unless it binds at least this tightly.
struct Piece {
  std::string text;
  NodeId node = no_node;
  int binding = loosest;
  bool spelled_out = false;
  bool as_truth = false; // a real number stands where C wants a condition
};

class Printer {
public:
  Printer(Schedule const &plan, FunctionContext const &context) : plan_(plan), context_(context) {}

  // An explicit stack instead of recursion; pieces are pushed last first.
  std::string print(NodeId root, bool spelled_out) {
    return print({.text = {}, .node = root, .binding = loosest, .spelled_out = spelled_out});
  }

  std::string print_condition(Literal literal) {
    auto [id, wanted] = literal;
    while (spelled_out(id) && node(id).op == Op::logical_not) {
      id = node(id).operand[0];
      wanted = !wanted;
    }
    bool const is_truth = is_gate(id) || (!is_leaf(node(id).op) && info(node(id).op).has(flag::BOOLEAN));
    if (!is_truth || !(is_variable(id) || spelled_out(id))) // a double
      return print({.text = {}, .node = id, .binding = additive}) + (wanted ? " != 0.0" : " == 0.0");
    if (!wanted && spelled_out(id) && (node(id).op == Op::eq || node(id).op == Op::ne)) {
      Node negated = node(id);
      negated.op = negated.op == Op::eq ? Op::ne : Op::eq;
      print_operation(negated, loosest);
      return finish();
    }
    if (!wanted) text_ = "!";
    return print({.text = {}, .node = id, .binding = wanted ? loosest : prefix_operand});
  }

private:
  std::string print(Piece piece) {
    stack_.push_back(std::move(piece));
    return finish();
  }

  std::string finish() {
    while (!stack_.empty()) {
      Piece piece = std::move(stack_.back());
      stack_.pop_back();
      if (piece.node == no_node)
        text_ += piece.text;
      else
        print_node(piece);
    }
    return std::move(text_);
  }

  Node const &node(NodeId id) const { return plan_.graph->nodes[id]; }
  bool is_gate(NodeId id) const { return id >= plan_.graph->nodes.size(); }
  bool is_variable(NodeId id) const { return (*context_.name)[id] != no_slot; }
  // Neither a variable nor an element of an array.
  bool spelled_out(NodeId id) const {
    if (is_gate(id)) return false;
    bool in_array = (context_.kept && (*context_.kept)[id] != no_slot) ||
                    (context_.in_compute && plan_.constant_slot[id] != no_slot);
    return !is_leaf(node(id).op) && !is_variable(id) && !in_array;
  }

  void print_node(Piece const &piece) {
    if (is_gate(piece.node)) {
      text_ += is_variable(piece.node) ? (*context_.spelling)((*context_.name)[piece.node])
                                       : "v[" + std::to_string((*context_.kept)[piece.node]) + "]";
      return;
    }
    Node const &node = plan_.graph->nodes[piece.node];
    bool is_kept = is_kept_value(piece);
    if (piece.as_truth && (is_leaf(node.op) || !info(node.op).has(flag::BOOLEAN) || is_kept)) {
      text_ += '(';
      push(" != 0.0)");
      return push(piece.node, additive);
    }
    if (node.is_constant()) return print_constant(node.value(), piece.binding);
    if (!piece.spelled_out && (*context_.name)[piece.node] != no_slot) {
      text_ += (*context_.spelling)((*context_.name)[piece.node]);
      return;
    }
    if (is_kept) return print_element(node, "v[" + std::to_string((*context_.kept)[piece.node]) + "]");
    if (context_.in_compute && plan_.constant_slot[piece.node] != no_slot)
      return print_element(node, "constants[" + std::to_string(plan_.constant_slot[piece.node]) + "]");
    if (is_leaf(node.op)) {
      text_ += (node.op == Op::input ? "input[" : "parameters[") + std::to_string(node.slot()) + "]";
      return;
    }
    if (context_.spelled_out) context_.spelled_out->push_back(piece.node);
    if (is_integer_constant(node)) {
      double const bits =
          evaluate(node.op, this->node(node.operand[0]).value(), this->node(node.operand[1]).value(), 0);
      text_ += c_integer_constant(integers::bits(bits));
      return;
    }
    print_operation(node, piece.binding);
  }

  void print_element(Node const &node, std::string const &element) {
    text_ += is_wide(node.op) ? c_kept_integer(element) : element;
  }

  // Of its two halves.
  bool is_integer_constant(Node const &node) const {
    return node.op == Op::wide && this->node(node.operand[0]).is_constant() &&
           this->node(node.operand[1]).is_constant();
  }

  bool is_kept_value(Piece const &piece) const {
    return context_.kept && !piece.spelled_out && (*context_.name)[piece.node] == no_slot &&
           (*context_.kept)[piece.node] != no_slot;
  }

  void print_constant(double value, int binding) {
    bool parenthesised = std::signbit(value) && binding > unary;
    text_ += parenthesised ? "(" + c_constant(value) + ")" : c_constant(value);
  }

  void print_operation(Node const &node, int binding) {
    OperationInfo const &operation = info(node.op);
    std::string c(operation.c);
    bool parenthesised = operation.precedence != 0 && operation.precedence < binding;
    if (parenthesised) {
      text_ += '(';
      push(")");
    }
    switch (operation.form) {
    case Form::local:
    case Form::call:
      push(")");
      print_arguments(node, operation.arity);
      push(c + "(");
      break;
    case Form::prefix:
      push(node.operand[0], prefix_operand, operation.has(flag::LOGICAL));
      push(c);
      break;
    case Form::cast:
      push(")");
      push(node.operand[0], loosest);
      push(c + "(");
      break;
    case Form::infix: {
      // Comparisons and logic are not mixed without parentheses: compilers warn, and readers stumble.
      bool arithmetic = operation.precedence >= additive;
      int left = arithmetic ? operation.precedence : additive, right = arithmetic ? operation.precedence + 1 : additive;
      bool logical = operation.has(flag::LOGICAL);
      push(node.operand[1], right, logical);
      push(operation.precedence > additive ? c : " " + c + " ");
      push(node.operand[0], left, logical);
      break;
    }
    case Form::select:
      push(node.operand[2], conditional_operand);
      push(" : ");
      push(node.operand[1], conditional_operand);
      push(" ? ");
      push(node.operand[0], conditional_operand, true);
      break;
    case Form::external: print_external(node); break;
    }
  }

  void print_arguments(Node const &node, unsigned count) {
    NodeId const hidden =
        context_.constant_paths ? hidden_operand(*plan_.graph, *context_.constant_paths, node) : no_node;
    for (unsigned i = count; i-- > 0;) {
      bool const hides = node.operand[i] == hidden;
      if (hides) push(")");
      push(node.operand[i], loosest);
      if (hides) push(std::string(hide) + "(");
      if (i > 0) push(", ");
    }
  }

  // An element of a table, or of the array that has the results of a call. Calls are statements of their own.
  void print_external(Node const &node) {
    Graph const &graph = *plan_.graph;
    if (node.op == Op::returned) {
      NodeId const call = node.operand[0];
      std::size_t const result = result_of(graph, node);
      bool const is_kept = context_.kept && (*context_.kept)[call] != no_slot;
      text_ += is_kept ? "v[" + std::to_string((*context_.kept)[call] + result) + "]"
                       : "r" + std::to_string((*context_.name)[call]) + "[" + std::to_string(result) + "]";
      return;
    }
    internal_check(node.op == Op::lookup || node.op == Op::lookup2);
    std::size_t const number = table_of(graph, node);
    std::vector<std::size_t> const &extents = graph.tables[number].extents;
    push("]");
    for (std::size_t dimension = extents.size(); dimension-- > 0;) {
      push(", " + std::to_string(extents[dimension]) + ")");
      push(node.operand[1 + dimension], loosest);
      push("table_index(");
      if (dimension == 1) push("*" + std::to_string(extents[1]) + " + ");
    }
    push("table_" + std::to_string(number) + "[");
  }

  void push(std::string text) { stack_.push_back({std::move(text)}); }
  void push(NodeId node, int binding, bool as_truth = false) {
    stack_.push_back({.text = {}, .node = node, .binding = binding, .as_truth = as_truth});
  }

  Schedule const &plan_;
  FunctionContext const &context_;
  std::vector<Piece> stack_;
  std::string text_;
};

} // namespace

std::string c_expression(Schedule const &plan, FunctionContext const &context, NodeId root) {
  return Printer(plan, context).print(root, true);
}

std::string c_condition(Schedule const &plan, FunctionContext const &context, Literal literal) {
  return Printer(plan, context).print_condition(literal);
}

std::string c_use(Schedule const &plan, FunctionContext const &context, NodeId node) {
  return Printer(plan, context).print(node, false);
}

} // namespace symreal
