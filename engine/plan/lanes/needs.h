// What a function computes, given its vectors: what that costs, and in which order it can be done.
#pragma once

#include "engine/plan/lanes/packs.h"

#include <limits>

namespace symreal::lanes {

// Results that are stored alone or as a vector, given the vectors.
class Needs {
public:
  Needs(Function const &function, Packs const &packs, std::vector<Store> const &stores)
      : function_(function),
        packs_(packs),
        stores_(stores) {}

  static constexpr double impossible = std::numeric_limits<double>::infinity();

  // In operations; `impossible` where vectors wait for each other. Linear in what is computed.
  double cost();

  // After that: what is needed, each behind what it needs.
  std::vector<Item> const &order() const { return order_; }
  // The operations that are computed alone.
  bool is_alone(NodeId id) const { return state_[id] == State::done && !packs_.place(id).is_given(); }

private:
  enum class State : char { unseen, open, done };
  using Key = std::uint32_t; // a node, or behind all nodes a vector

  Key key(VectorId id) const { return static_cast<Key>(function_.graph().nodes.size()) + id; }
  bool is_vector(Key key) const { return key >= function_.graph().nodes.size(); }
  bool visit(Key root);
  void expand(Key key);
  void expand_node(NodeId id);
  void expand_vector(VectorId id);
  double price(Source const &source, std::vector<NodeId> const &nodes);

  Function const &function_;
  Packs const &packs_;
  std::vector<Store> const &stores_;
  std::vector<State> state_;
  std::vector<Key> stack_;
  std::vector<Source::Part> windows_;
  std::vector<Item> order_;
  double cost_ = 0;
};

} // namespace symreal::lanes
