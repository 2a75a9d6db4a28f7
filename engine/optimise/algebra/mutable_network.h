// A network whose nodes can be given other operands, with the users of each: what resubstitution works on.
#pragma once

#include "engine/optimise/algebra/key_table.h"
#include "engine/optimise/algebra/network.h"

#include <utility>

namespace symreal::algebra {

class MutableNetwork {
public:
  explicit MutableNetwork(Network const &network);

  std::size_t size() const { return nodes_.size(); }
  NetworkNode const &operator[](Index node) const { return nodes_[node]; }
  Value value(Literal literal) const;
  bool is_alive(Index node) const { return references_[node] > 0; }
  std::span<Index const> users(Index node) const { return users_[node]; }
  HazardSets const &hazards() const { return source_.hazards(); }
  template <class Visit> void for_each_operand(Index node, Visit const &visit) const {
    source_.for_each_operand(nodes_[node], visit);
  }

  // The node that is alive and has this value at the first point of the field, or the negative; or no_index.
  Index find(Residue first) const;

  int cost(Index node) const { return source_.cost(nodes_[node]); }
  // The cost of what is needed for this node alone; of a large cone, of so many nodes of it.
  int cone_cost(Index node);
  // The cost of what is freed when the node no longer needs its operands, while `kept` are needed anew; as above.
  int freed(Index node, std::span<Literal const> kept);
  // Finds all that needs a node; then whether one does.
  void look_for_users(Index node);
  bool needs_it(Index node) const { return visited_[node] == search_; }
  // How many nodes these have looked at beyond what the windows of a search have, since this was last asked.
  std::uint64_t take_far_visits() { return std::exchange(far_visits_, 0); }

  // A node of two operands, new or one with this value.
  Literal make(Kind kind, Literal a, Literal b);
  Literal constant(Value const &value);
  // Gives the node other operands, which make the same value or its negative.
  void replace(Index node, Kind kind, Literal a, Literal b);

  Network finished() const;

private:
  int release_operands(Index node, std::size_t most);
  Index append(NetworkNode const &node);
  void add_user(Literal operand, Index user);

  Network const &source_;
  std::vector<NetworkNode> nodes_;
  std::vector<std::uint32_t> references_;
  std::vector<std::vector<Index>> users_; // some may be users no longer
  std::vector<std::uint32_t> visited_;    // in which search for users
  std::uint32_t search_ = 0;
  std::vector<Index> open_, released_;
  std::uint64_t far_visits_ = 0;
  KeyTable by_value_;
  std::vector<Literal> roots_;
};

} // namespace symreal::algebra
