// Lane function: a function whose operations are partly vector operations; the input of the emitters.
#pragma once

#include "engine/graph/node.h"
#include "engine/plan/value.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace symreal::lanes {

using VectorId = std::uint32_t;
inline constexpr VectorId no_vector = ~VectorId{0};

// A vector of numbers, one in each lane.
struct Vector {
  enum class Form : std::uint8_t {
    operation, // applies `op` to the operands, lane by lane
    constants, // literals
    splat,     // one number in all lanes
    load,      // contiguous elements of an array
    shuffle,   // lanes of one operand or of two
    build,     // scalars of any origin
  } form = Form::build;
  std::vector<NodeId> nodes = {}; // per lane; no_node in a load for an unused element
  Op op = Op::add;
  std::vector<char> subtracts = {}; // per lane of a sum: whether it is a difference; empty: `op` holds in all lanes
  std::array<VectorId, 2> operand = {no_vector, no_vector};
  std::vector<std::uint32_t> from = {}; // of a shuffle: lane of the first operand; from the width on, of the second
  Array array = Array::input;
  std::size_t first = 0; // of a load
};

// The forms as the text form of a plan spells them, in the order of the enumerators; an operation has its own name.
inline constexpr std::array<std::string_view, 6> form_names = {"", "constants", "splat", "load", "shuffle", "build"};

struct Lane {
  VectorId vector = no_vector;
  std::uint32_t lane = 0;

  bool is_given() const { return vector != no_vector; }
};

// A vector store to contiguous results.
struct Store {
  VectorId vector;
  std::size_t first;
};

// A vector, or a scalar operation.
struct Item {
  bool is_vector;
  std::uint32_t id;
};

struct LaneFunction {
  std::size_t width = 0;
  std::vector<Vector> vectors = {};
  std::vector<Lane> lane = {}; // per node: the lane that computes it; none for scalar operations
  std::vector<Store> stores = {};
  std::vector<Item> order = {};             // operations and vectors, each behind its operands
  std::size_t operations = 0, in_lanes = 0; // operation counts of the graph

  // Whether a scalar store stores the result.
  bool is_stored_alone(std::size_t slot) const {
    return std::ranges::none_of(stores, [&](Store const &s) { return slot >= s.first && slot < s.first + width; });
  }
};

} // namespace symreal::lanes
