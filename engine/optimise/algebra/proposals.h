// Proposals: alternative computations of a node.
#pragma once

#include "engine/optimise/algebra/mutable_network.h"
#include "engine/optimise/algebra/resubstitution.h"

#include <array>

namespace symreal::algebra {

// Computation of a node in up to three operations, the last of which is the node. Operands may be results of earlier
// steps, or the constant.
struct Proposal {
  struct Step {
    Kind kind;
    Literal a, b;
  };
  static constexpr std::uint32_t first_result = ~std::uint32_t{0} - 15;
  static Literal result(std::uint32_t step, bool negative = false) {
    return {first_result + 2 * step + static_cast<std::uint32_t>(negative)};
  }
  static Literal constant_result() { return result(7); }
  static bool is_result(Literal literal) { return literal.bits >= first_result; }

  std::array<Step, 3> steps{};
  int operations = 0;
  int gain = -1;
  Value constant{};
};

// Finds the best proposal for each node.
class Proposals {
public:
  Proposals(MutableNetwork &network, ResubstitutionSettings const &settings, Search &search);

  Proposal best_for(Index target);
  // Registers each node added to the network, in order.
  void add(Index node);

private:
  struct Pair {
    Kind kind;
    Literal a, b;
    Residue value;
  };

  Residue first(Index node) const { return network_[node].value.field[0]; }
  void look_around();
  Residue rest(Index other, bool negative) const;
  void invert_rests();
  void try_sum(std::size_t near);
  void try_sum_with_multiple(Index other, bool negative, Residue inverse_rest);
  void try_multiple();
  void try_product(Index other);
  void make_pairs();
  Value value(Pair const &pair) const;
  void try_with_pair(Index other);
  void try_two_products();
  bool multiple_of(Value const &value, Index node, Value &k) const;
  bool matches(Value const &value, Literal part) const;
  void consider(Proposal proposal);

  MutableNetwork &network_;
  ResubstitutionSettings const &settings_;
  Search &search_;
  std::vector<Residue> inverse_, ratio_; // inverse of the value at point 0; ratio of those at points 1 and 0
  KeyTable by_ratio_;
  std::vector<Index> near_;
  std::vector<Residue> inverse_rests_; // two per neighbour
  std::vector<char> is_near_;
  std::vector<Pair> pairs_;
  KeyTable pair_by_value_;
  Index target_ = 0;
  int cone_ = 0; // cost of the target's fanout-free cone
  Proposal best_;
};

} // namespace symreal::algebra
