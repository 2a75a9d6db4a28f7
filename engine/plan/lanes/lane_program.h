// A function whose operations are in part computed side by side: what an emitter prints.
#pragma once

#include "engine/plan/schedule/schedule.h"

#include <array>
#include <vector>

namespace symreal::lanes {

using VectorId = std::uint32_t;
inline constexpr VectorId no_vector = ~VectorId{0};

// Numbers side by side, one in each lane.
struct Vector {
  enum class Form : std::uint8_t {
    operation, // of the operands, lane by lane
    constants, // written down
    splat,     // one number in all lanes
    load,      // elements of an array that stand side by side
    shuffle,   // lanes of one operand or of two
    build,     // numbers from anywhere
  } form = Form::build;
  std::vector<NodeId> nodes = {}; // per lane; of a load no_node where nobody wants the element
  Op op = Op::add;
  std::vector<char> subtracts = {}; // per lane: of a sum that is a difference there; empty: all lanes are as `op` says
  std::array<VectorId, 2> operand = {no_vector, no_vector};
  std::vector<std::uint32_t> from = {}; // of a shuffle: a lane of the first operand or, beyond the width, of the second
  Array array = Array::input;
  std::size_t first = 0; // of a load
};

struct Lane {
  VectorId vector = no_vector;
  std::uint32_t lane = 0;

  bool is_given() const { return vector != no_vector; }
};

// Results that stand side by side.
struct Store {
  VectorId vector;
  std::size_t first;
};

// A vector, or an operation that is computed alone.
struct Item {
  bool is_vector;
  std::uint32_t id;
};

struct LaneFunction {
  std::size_t width = 0;
  std::vector<Vector> vectors = {};
  std::vector<Lane> lane = {}; // per node: where it is computed, if it is not alone
  std::vector<Store> stores = {};
  std::vector<Item> order = {};             // what is computed: each behind what it needs
  std::size_t operations = 0, in_lanes = 0; // of the graph

  // Whether a result is stored by itself.
  bool is_stored_alone(std::size_t slot) const;
};

} // namespace symreal::lanes
