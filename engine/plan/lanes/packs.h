// Packs: the vectors of a function during the search, with the sources of those that are not operations.
#pragma once

#include "engine/plan/lanes/scalar_function.h"

#include <map>
#include <optional>

namespace symreal::lanes {

// Origin of the numbers of a vector other than an operation.
struct Source {
  // A window of array elements, or a computed vector.
  struct Window {
    VectorId pack = no_vector; // no_vector: array elements
    Array array = Array::input;
    std::size_t first = 0;

    bool is_load() const { return pack == no_vector; }
    bool operator==(Window const &) const = default;
  };
  Vector::Form form;
  std::vector<Window> parts = {}; // one for a load, one or two for a shuffle
  std::vector<std::uint32_t> from = {};
  std::size_t column = 0, stride = 0; // of a build from elements a stride apart, such as a matrix column
};

class Packs {
public:
  explicit Packs(ScalarFunction const &function) : function_(function), places_(function.graph().nodes.size()) {}

  struct Pack {
    std::vector<NodeId> nodes;
    bool is_operation = false; // otherwise it has a source
    Op op = Op::add;
    std::vector<char> subtracts = {};
    std::array<VectorId, 2> operand = {no_vector, no_vector};
  };

  std::size_t size() const { return packs_.size(); }
  Pack const &operator[](VectorId id) const { return packs_[id]; }

  // Vector of these nodes. It is an operation if the nodes are isomorphic and not yet in vectors; its operands are
  // grown likewise.
  VectorId grow(std::vector<NodeId> const &nodes);
  // Removes all vectors from number `size` on.
  void cut(std::size_t size);
  // Sets whether the vector is an operation, or is built from scalars.
  void set_operation(VectorId id, bool is_operation);

  // Lane that computes the node: in the first vector that has it.
  Lane place(NodeId id) const { return places_[id].empty() ? Lane{} : places_[id].front(); }
  Source source(VectorId id) const;

private:
  VectorId find_or_add(std::vector<NodeId> const &nodes);
  void try_operation(VectorId id);
  std::optional<Source> shuffled(std::vector<NodeId> const &nodes) const;
  std::optional<Source> loaded(std::vector<NodeId> const &nodes) const;
  std::optional<Source> column(std::vector<NodeId> const &nodes) const;
  std::optional<std::uint32_t> lane_in(NodeId node, Source::Window const &part) const;
  std::optional<Source> from_parts(std::vector<NodeId> const &nodes, Source::Window const &first,
                                   std::vector<Source::Window> const &others) const;

  ScalarFunction const &function_;
  std::vector<Pack> packs_;
  std::map<std::vector<NodeId>, VectorId> by_nodes_;
  std::vector<std::vector<Lane>> places_; // per node
  std::vector<VectorId> new_;
};

} // namespace symreal::lanes
