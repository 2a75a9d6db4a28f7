// Mutable network with user lists, on which resubstitution works.
#pragma once

#include "engine/optimise/algebra/key_table.h"
#include "engine/optimise/algebra/network.h"

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

  // Live node with this value or its negative at the first field point; no_index if absent.
  Index find(Residue first) const;

  int cost(Index node) const { return source_.cost(nodes_[node]); }
  // Cost of the node's maximal fanout-free cone, cut off at the size of the largest window.
  int cone_cost(Index node);
  // Cost of the nodes that die when the node drops its operands but `kept` stay alive; cut off likewise.
  int freed(Index node, std::span<Literal const> kept);
  // Finds the transitive users of a node; needs_it then tests membership.
  void look_for_users(Index node);
  bool needs_it(Index node) const { return visited_[node] == search_; }
  // Number of nodes visited beyond the size of a search window since the last call.
  std::uint64_t take_far_visits() { return std::exchange(far_visits_, 0); }

  // A new node of two operands.
  Literal make(Kind kind, Literal a, Literal b);
  Literal constant(Value const &value);
  // Replaces the node's operation and operands; the new value is the old one or its negative.
  void replace(Index node, Kind kind, Literal a, Literal b);

  Network finished() const;

private:
  int release_operands(Index node, std::size_t most);
  Index append(NetworkNode const &node);
  void add_user(Literal operand, Index user);

  Network const &source_;
  std::vector<NetworkNode> nodes_;
  std::vector<std::uint32_t> references_;
  std::vector<std::vector<Index>> users_; // possibly stale
  std::vector<std::uint32_t> visited_;    // the last search that visited the node
  std::uint32_t search_ = 0;
  std::vector<Index> open_, released_;
  std::uint64_t far_visits_ = 0;
  KeyTable by_value_;
  std::vector<Literal> roots_;
};

} // namespace symreal::algebra
