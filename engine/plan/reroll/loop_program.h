// A function as steps, each of which computes its body once or as often as a loop goes round: what an emitter prints.
#pragma once

#include "engine/graph/graph.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace symreal::reroll {

// Iterations of two loops, one in the other: in turn i of the outer one the inner one goes round inner + growth * i
// times.
struct Nest {
  std::uint32_t turns, inner;
  std::int32_t growth;
  auto operator<=>(Nest const &) const = default;
};

// An element of an array for each iteration.
struct Access {
  std::int64_t first = 0, step = 0;         // first + step * iteration
  std::vector<std::uint32_t> elements = {}; // where no step fits: one per iteration

  bool is_listed() const { return !elements.empty(); }
  std::size_t at(std::size_t iteration) const {
    return is_listed() ? elements[iteration]
                       : static_cast<std::size_t>(first + step * static_cast<std::int64_t>(iteration));
  }
};

// What an input of a body stands for.
struct Leaf {
  enum class Kind : std::uint8_t {
    given, // an element of what the function is given: inputs, or in preprocess parameters
    read,  // an element of what preprocess stored
    sine,  // an element of the sines, or of the cosines, that the function begins with
    cosine,
    memory,  // an element of the function's own array
    values,  // values[iteration % size], or by turns of the outer of two loops: values[turn % size]
    carried, // in the first iteration that element of memory, then the value `next`, maybe a leaf, of the one before
  } kind;
  Access access = {};
  std::vector<double> values = {};
  bool by_turn = false;
  NodeId next = no_node;
};

// Behind each iteration, in this order: an element of memory, or of what the function fills.
struct Store {
  NodeId value;
  bool is_result = false;
  Access access = {};
};

struct Step {
  Graph body; // its input k is leaf k; its results are what is stored and carried
  std::uint32_t count = 1;
  std::vector<Leaf> leaves = {};
  std::vector<Store> stores = {};
  std::optional<Nest> nest = {}; // whose iterations these are, where that is known before
};

// When all steps are done: a symmetric matrix among what the function fills, row by row. What stands below its diagonal
// is copied from above, or the other way round.
struct Mirror {
  std::uint32_t first, rows;
  bool from_above;
};

// Whether it is of an array that the caller passes: results may overlap with it.
inline bool is_argument(Leaf::Kind kind) { return kind == Leaf::Kind::given || kind == Leaf::Kind::read; }
inline bool reads_arguments(Step const &step) { return std::ranges::any_of(step.leaves, is_argument, &Leaf::kind); }

struct LoopFunction {
  std::vector<Step> steps;
  std::vector<Mirror> mirrors = {};
  std::size_t memory = 0;                 // elements of the function's own array
  std::vector<std::uint32_t> checks = {}; // per guard: the element of memory that must not be 0
  std::size_t operations = 0, in_loops = 0, loops = 0;
};

} // namespace symreal::reroll
