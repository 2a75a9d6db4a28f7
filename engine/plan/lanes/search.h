// Search for operations to pack into vectors, by the cost of the function with them.
//
// Vectors start at contiguous results and at operations of one shape, and grow along their operands. Vectors that
// reduce the function's cost are kept.
#pragma once

#include "engine/plan/lanes/packs.h"

#include <limits>

namespace symreal::lanes {

// The operations that stored results need, given the vectors.
class Needs {
public:
  Needs(ScalarFunction const &function, Packs const &packs, std::vector<Store> const &stores)
      : function_(function),
        packs_(packs),
        stores_(stores) {}

  static constexpr double impossible = std::numeric_limits<double>::infinity();

  // Cost in operations; `impossible` if vectors depend on each other. Linear in the operations.
  double cost();

  // Needed items, each behind its operands; valid after cost().
  std::vector<Item> const &order() const { return order_; }
  // Whether the node is a needed scalar operation.
  bool is_alone(NodeId id) const { return state_[id] == State::done && !packs_.place(id).is_given(); }

private:
  enum class State : char { unseen, open, done };
  using Key = std::uint32_t; // a node; from the node count on, a vector

  Key key(VectorId id) const { return static_cast<Key>(function_.graph().nodes.size()) + id; }
  bool is_vector(Key key) const { return key >= function_.graph().nodes.size(); }
  bool visit(Key root);
  void expand(Key key);
  void expand_node(NodeId id);
  void expand_vector(VectorId id);
  double price(Source const &source, std::vector<NodeId> const &nodes);

  ScalarFunction const &function_;
  Packs const &packs_;
  std::vector<Store> const &stores_;
  std::vector<State> state_;
  std::vector<Key> stack_;
  std::vector<Source::Window> windows_;
  std::vector<Item> order_;
  double cost_ = 0;
};

// Vectors that pay, and the vector stores among them.
struct VectorChoice {
  Packs packs;
  std::vector<Store> stores;
};

VectorChoice search(ScalarFunction const &function);

// Lane function of the vectors that the search found: their sources and order.
LaneFunction lane_function(ScalarFunction const &function, VectorChoice const &found);

} // namespace symreal::lanes
