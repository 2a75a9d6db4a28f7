// Loop program: a function as steps, each a body that is computed once or in a loop; the input of the emitters.
#pragma once

#include "engine/graph/graph.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace symreal::reroll {

// A loop nest: in turn i of the outer loop, the inner loop has inner + growth * i iterations.
struct Nest {
  std::uint32_t turns, inner;
  std::int32_t growth;
  auto operator<=>(Nest const &) const = default;
};

// Element index of an array as a function of the iteration.
struct Access {
  std::int64_t first = 0, step = 0;         // first + step * iteration
  std::vector<std::uint32_t> elements = {}; // one per iteration if the index is not affine

  bool is_listed() const { return !elements.empty(); }
  std::size_t at(std::size_t iteration) const {
    return is_listed() ? elements[iteration]
                       : static_cast<std::size_t>(first + step * static_cast<std::int64_t>(iteration));
  }
};

// Source of a body's input.
struct Leaf {
  enum class Kind : std::uint8_t {
    given, // an element of the function's input: inputs, or in preprocess parameters
    read,  // an element that preprocess stored
    sine,  // an element of the sines or cosines at the start of the function
    cosine,
    memory,  // an element of the function's own array
    values,  // values[iteration % size]; if by_turn, values[turn % size] of the outer loop
    carried, // loop-carried: first that element of memory, then the previous iteration's value of `next`
  } kind;
  Access access = {};
  std::vector<double> values = {};
  bool by_turn = false;
  NodeId next = no_node;
};

// A store at the end of each iteration, in order: to an element of memory, or of an output.
struct Store {
  NodeId value;
  bool is_result = false;
  Access access = {};
};

struct Step {
  Graph body; // input k is leaf k; results are the stored and the carried values
  std::uint32_t count = 1;
  std::vector<Leaf> leaves = {};
  std::vector<Store> stores = {};
  std::optional<Nest> nest = {}; // loop nest of the iterations, if known beforehand
};

// A symmetric matrix among the outputs, stored by rows. After all steps, the half below its diagonal is copied from the
// half above, or the other way round.
struct Mirror {
  std::uint32_t first, rows;
  bool from_above;
};

// Whether the leaf reads an array that the caller passes, which outputs may overlap.
inline bool is_argument(Leaf::Kind kind) { return kind == Leaf::Kind::given || kind == Leaf::Kind::read; }
inline bool reads_arguments(Step const &step) { return std::ranges::any_of(step.leaves, is_argument, &Leaf::kind); }

struct LoopFunction {
  std::vector<Step> steps;
  std::vector<Mirror> mirrors = {};
  std::size_t memory = 0;                 // size of the function's own array
  std::vector<std::uint32_t> checks = {}; // per guard: the element of memory that must be nonzero
  std::size_t operations = 0, in_loops = 0, loops = 0;
};

} // namespace symreal::reroll
