// Prints one expression. Shared by expression.cpp, which knows nodes, and operation.cpp, which knows operations.
#pragma once

#include "emit/print/expression.h"

#include <forward_list>
#include <span>
#include <string>
#include <vector>

namespace symreal {

class ExpressionPrinter {
public:
  // What stands at a place of the text: a number, a truth value, or the node as it is.
  enum class As : std::uint8_t { number, truth, itself };

  // What is still to be printed: text, or a node that needs parentheses unless it binds at least this tightly.
  struct Item {
    std::string_view text = {};
    NodeId node = no_node;
    int binding = binding::loosest;
    As as = As::itself;
    bool spelled_out = false; // even if it has a variable
  };

  explicit ExpressionPrinter(FunctionContext &context)
      : context_(context),
        language_(context.emission.language),
        graph_(context.graph()) {}

  std::string print(Item item);
  std::string print_condition(Literal literal);

private:
  std::string finish();

  Node const &node(NodeId id) const { return graph_.nodes[id]; }
  bool is_variable(NodeId id) const { return context_.variable[id] != no_slot; }
  bool is_kept(NodeId id) const { return !is_variable(id) && context_.kept[id] != no_slot; }
  bool is_precomputed(NodeId id) const {
    return context_.in_compute && !context_.is_gate(id) && context_.emission.plan.constant_slot[id] != no_slot;
  }
  bool spelled_out(NodeId id) const;
  bool is_truth(NodeId id) const;
  bool is_element(Item const &item) const;
  std::string variable(NodeId id) const { return context_.spelling(context_.variable[id]); }

  void print_node(Item const &item);
  void print_itself(Item const &item);
  void print_element(Node const &node, std::string const &element);
  void print_constant(double value, int binding);

  bool is_integer_constant(Node const &node) const;
  void print_integer_constant(Node const &node);
  void print_operation(Node const &node, int binding);
  void print_external(Node const &node);
  void push_comparison(Op op, NodeId id);
  void push_pattern(Op op, std::span<Item const> operands, NodeId hidden = no_node);
  void push_hidden(Item const &operand);
  void push(std::string_view text) { stack_.push_back({.text = text}); }
  // Text that lives as long as the printer.
  std::string_view lasting(std::string text) { return lasting_.emplace_front(std::move(text)); }

  FunctionContext &context_;
  Language const &language_;
  Graph const &graph_;
  std::vector<Item> stack_; // instead of recursion; items are pushed last first
  std::string text_;
  std::forward_list<std::string> lasting_;
};

} // namespace symreal
