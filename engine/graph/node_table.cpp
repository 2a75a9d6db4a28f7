#include "engine/graph/node_table.h"

#include <algorithm>
#include <utility>

namespace symreal {

static std::size_t hash(Node const &node) {
  constexpr std::uint64_t odd = 0x9E3779B97F4A7C15u;
  std::uint64_t mix = static_cast<std::uint64_t>(node.op);
  for (NodeId word : node.operand) {
    mix = (mix ^ word) * odd;
    mix ^= mix >> 32;
  }
  return static_cast<std::size_t>(mix * odd >> 7);
}

NodeId NodeTable::intern_in_hash(Node const &node) {
  if (2 * (hashed_ + 1) > hash_.size()) grow_hash();
  std::size_t mask = hash_.size() - 1, place = hash(node) & mask;
  for (; hash_[place] != no_node; place = (place + 1) & mask)
    if (nodes_[hash_[place]] == node) return hash_[place];
  ++hashed_;
  return hash_[place] = append(node);
}

void NodeTable::grow_hash() {
  LongArray<NodeId> old(std::max<std::size_t>(64, 2 * hash_.size()), no_node);
  old.swap(hash_);
  std::size_t mask = hash_.size() - 1;
  for (NodeId id : old) {
    if (id == no_node) continue;
    std::size_t place = hash(nodes_[id]) & mask;
    while (hash_[place] != no_node) place = (place + 1) & mask;
    hash_[place] = id;
  }
}

void NodeTable::reserve(std::size_t count) {
  nodes_.reserve(count);
  links_.reserve(count);
  attributes_.reserve(count);
  constexpr std::size_t many = std::size_t{1} << 17; // enough for the hash to have pages of its own
  if (count >= many / 2 && hash_.empty()) hash_.assign(many, no_node);
}

Nodes NodeTable::release() {
  bool const uses_little = nodes_.size() < nodes_.capacity() / 16; // of the reserved memory, which then stays
  Nodes nodes = uses_little ? nodes_ : std::move(nodes_);
  if (!uses_little) *this = {}; // the links are equally long
  clear();
  return nodes;
}

void NodeTable::clear() {
  nodes_.clear();
  links_.clear();
  attributes_.clear();
  hash_.clear();
  hashed_ = 0;
}

} // namespace symreal
