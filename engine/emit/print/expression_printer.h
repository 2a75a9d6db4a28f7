// Printer of one expression, implemented in expression.cpp (nodes) and operation.cpp (operations).
#pragma once

#include "engine/emit/print/expression.h"

#include <forward_list>
#include <span>
#include <string>
#include <vector>

namespace symreal {

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

  void print(Item item);
  void print_condition(Literal literal);

private:
  void finish();

  Node const &node(NodeId id) const { return graph_.nodes[id]; }
  bool is_variable(NodeId id) const { return context_.variable[id] != no_slot; }
  bool is_kept(NodeId id) const { return !is_variable(id) && context_.kept[id] != no_slot; }
  // Array element of a node computed by preprocess, or at the start of the function; nullopt for other nodes.
  std::optional<Element> precomputed(NodeId id) const {
    if (!context_.in_compute || context_.is_gate(id)) return {};
    std::optional<Element> const element = context_.emission.plan.element(id);
    return element && element->array != Array::input ? element : std::nullopt;
  }
  bool is_precomputed(NodeId id) const { return precomputed(id).has_value(); }
  bool spelled_out(NodeId id) const;
  bool is_truth(NodeId id) const;
  bool is_element(Item const &item) const;
  bool is_plain(Item const &item) const;
  bool is_integer(NodeId id) const;
  void convert_integers(OperationInfo const &operation, std::span<Item> operands) const;
  void print_variable(NodeId id) { context_.spelling.append_to(text_, context_.variable[id]); }

  void print_node(Item const &item);
  void print_itself(Item const &item);
  void print_element(Node const &node, std::string_view array, std::size_t index);
  void print_constant(double value, int binding);

  bool is_integer_constant(Node const &node) const;
  void print_integer_constant(Node const &node);
  void print_operation(Node const &node, int binding);
  void print_external(Node const &node);
  void push_comparison(Op op, NodeId id);
  void push_pattern(Op op, std::span<Item const> operands, NodeId hidden = no_node);
  void push_hidden(Item const &operand);
  void push(std::string_view text) { stack_.push_back({.text = text}); }
  // Text with the lifetime of the printer.
  std::string_view lasting(std::string text) { return lasting_.emplace_front(std::move(text)); }

  FunctionContext &context_;
  Language const &language_;
  Graph const &graph_;
  std::vector<Item> &stack_; // replaces recursion; items are pushed last first
  std::size_t others_;       // number of items of enclosing expressions
  std::string &text_;
  std::forward_list<std::string> lasting_;
};

} // namespace symreal
