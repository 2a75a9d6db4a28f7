// Table of nodes under construction, hash-consed: equal nodes exist once.
//
// Method: a node is looked up in the list of users of its newest operand. In a recorded program that list is short and
// recent, hence in cache; this measures two to five times faster than open addressing and needs no rehashing. For an
// operand with many users (a hub), users beyond `longest_list` are in an ordinary hash table. A list never exceeds that
// length, so a lookup always sees all of it.
#pragma once

#include "engine/graph/node.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace symreal {

class NodeTable {
public:
  // Id of the node equal to this one, new or old. `operand` entries beyond the arity must be no_node.
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
  // Appends a new node in any case, for reading graphs with duplicates. Interning may or may not find it later.
  NodeId append(Node const &node) { return append(node, no_node); }

  NodeId constant(double value) { return intern(Node::constant(value)); }
  // An operation on nodes of this table; its attribute follows from its operands.
  Node operation(Op op, NodeId a, NodeId b = no_node, NodeId c = no_node) const {
    Attribute attribute = attributes_[a];
    if (b != no_node) attribute = std::max(attribute, attributes_[b]);
    if (c != no_node) attribute = std::max(attribute, attributes_[c]);
    return {op, attribute_of(op, attribute), {a, b, c}};
  }

  // Likewise, for + - * / only.
  Node arithmetic(Op op, NodeId a, NodeId b) const {
    return {op, std::max(attributes_[a], attributes_[b]), {a, b, no_node}};
  }

  Nodes const &nodes() const { return nodes_; }
  Node const &operator[](NodeId id) const { return nodes_[id]; }
  std::size_t size() const { return nodes_.size(); }
  // Reserves memory for this many nodes.
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
  LongArray<Attribute> attributes_; // per node; a copy, so that those of old operands stay in cache
  LongArray<NodeId> hash_;          // open addressing: leaves, and users of hubs
  std::size_t hashed_ = 0;
};

} // namespace symreal
