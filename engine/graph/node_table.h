// The nodes of a graph under construction, hash consed: no computation exists twice.
//
// Method: a node is looked up in the list of users of its newest operand. In a recorded program that list is short and
// recent, hence in cache; measured against open addressing this is two to five times faster and needs no rehashing. An
// operand with many users (a hub) would make the list long, so after `longest_list` steps the remaining users of that
// operand live in an ordinary hash table. A list never grows beyond that length, so every member is always seen.
#pragma once

#include "engine/graph/node.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace symreal {

class NodeTable {
public:
  // The node with this key, new or old. `operand` entries beyond the arity are no_node.
  NodeId intern(Node const &node) {
    if (is_leaf(node.op)) return intern_in_hash(node);
    NodeId &newest = links_[newest_operand(node)].first_user;
    int steps = 0;
    for (NodeId user = newest; user != no_node; user = links_[user].next) {
      if (nodes_[user] == node) return user;
      if (++steps == longest_list) return intern_in_hash(node);
    }
    NodeId const next = std::exchange(newest, static_cast<NodeId>(nodes_.size()));
    return append(node, next);
  }
  // Always a new node: how a graph is read that may hold duplicates. Interning may or may not find it later.
  NodeId append(Node const &node) { return append(node, no_node); }

  NodeId constant(double value) { return intern(Node::constant(value)); }
  // An operation on nodes of this table; its attribute follows from its operands.
  Node operation(Op op, NodeId a, NodeId b = no_node, NodeId c = no_node) const {
    Attribute attribute = attributes_[a];
    if (b != no_node) attribute = std::max(attribute, attributes_[b]);
    if (c != no_node) attribute = std::max(attribute, attributes_[c]);
    return {op, attribute_of(op, attribute), {a, b, c}};
  }

  // The same of + - * /.
  Node arithmetic(Op op, NodeId a, NodeId b) const {
    return {op, std::max(attributes_[a], attributes_[b]), {a, b, no_node}};
  }

  Nodes const &nodes() const { return nodes_; }
  Node const &operator[](NodeId id) const { return nodes_[id]; }
  std::size_t size() const { return nodes_.size(); }
  // Makes room for so many nodes at once.
  void reserve(std::size_t count);
  // Hands the nodes over; the table is empty afterwards.
  Nodes release();
  void clear();

private:
  static constexpr int longest_list = 16;

  static NodeId newest_operand(Node const &node) {
    NodeId newest = node.operand[0];
    if (node.operand[1] != no_node) newest = std::max(newest, node.operand[1]);
    if (node.operand[2] != no_node) newest = std::max(newest, node.operand[2]);
    return newest;
  }
  NodeId append(Node const &node, NodeId next) {
    nodes_.push_back(node);
    links_.push_back({no_node, next});
    attributes_.push_back(node.attribute);
    return static_cast<NodeId>(nodes_.size() - 1);
  }
  NodeId intern_in_hash(Node const &node);
  void grow_hash();

  struct Links {
    NodeId first_user; // newest entry of the node's list of users
    NodeId next;       // next entry of the list that the node is in
  };

  Nodes nodes_;
  LongArray<Links> links_;          // per node
  LongArray<Attribute> attributes_; // per node once more: those of old operands stay in the cache like this
  LongArray<NodeId> hash_;          // open addressing: leaves, and users of hubs
  std::size_t hashed_ = 0;
};

} // namespace symreal
