// Loop function: a function as steps, each a body that is computed once or in a loop; the input of the emitters.
#pragma once

#include "engine/graph/graph.h"
#include "engine/graph/node_table.h"
#include "engine/plan/nest.h"
#include "engine/plan/value.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace symreal::reroll {

// Source of a body's input: an element of an array, or of a table that repeats.
struct Leaf {
  Array array;
  Access access = {};
  std::vector<double> values = {}; // of Array::values: values[iteration % size]; if by_turn, of the outer loop's turn
  bool by_turn = false;
  bool is_carried = false; // loop-carried: the element of memory first, then the previous iteration's value of `next`
  NodeId next = no_node;
};

// A store at the end of each iteration, in order: to an element of memory, or of an output.
struct Store {
  NodeId value;
  bool is_result = false;
  Access access = {};
};

struct LoopStep {
  Graph body; // input k is leaf k; results are the stored and the carried values
  std::uint32_t count = 1;
  std::vector<Leaf> leaves = {};
  std::vector<Store> stores = {};
  std::optional<Nest> nest = {}; // loop nest of the iterations, if known beforehand
};

// Value of a leaf of array `values` in an iteration. `nest`: that of its step.
double value_at(Leaf const &leaf, std::uint32_t iteration, std::optional<Nest> const &nest);

// Loop nest of the step; if it is not known beforehand, the one that fits its accesses.
std::optional<Nest> nest_of(LoopStep const &step);

// Whether compilers may vectorise the loop of the step without changing results: iterations are independent, and no two
// stores of one iteration can be neighbours.
//
// gcc's vectoriser, in its pattern addsub, fuses a product with the sum behind it, whatever the flags, if sums and
// differences alternate in neighbouring elements of memory. It takes stores of one iteration to neighbouring
// elements, so a loop without such stores is safe: its vectors hold one operation of several iterations. Small inner
// loops are unrolled first, and then the stores of several inner iterations belong to one outer iteration.
bool is_side_by_side(LoopStep const &step);

// Whether the step reads arrays that the caller passes, which outputs may overlap.
inline bool reads_arguments(LoopStep const &step) {
  return std::ranges::any_of(step.leaves, is_argument, &Leaf::array);
}

// A symmetric matrix among the outputs, stored by rows. After all steps, the half below its diagonal is copied from the
// half above, or the other way round.
struct Mirror {
  std::uint32_t first, rows;
  bool from_above;
};

// Calls visit(to, from) for each copied result and its source.
template <class Visit> void for_each_copy(Mirror const &mirror, Visit const &visit) {
  for (std::uint32_t row = 0; row < mirror.rows; ++row)
    for (std::uint32_t column = 0; column < row; ++column) {
      std::uint32_t const below = mirror.first + mirror.rows * row + column;
      std::uint32_t const above = mirror.first + mirror.rows * column + row;
      mirror.from_above ? visit(below, above) : visit(above, below);
    }
}

struct LoopFunction {
  std::vector<LoopStep> steps;
  std::vector<Mirror> mirrors = {};
  std::size_t memory = 0;                 // size of the function's own array
  std::vector<std::uint32_t> checks = {}; // per guard: the element of memory that must be nonzero
  std::size_t operations = 0, in_loops = 0, loops = 0;
};

// Builder of a step, whose body is a graph with the leaves as its inputs.
class BodyBuilder {
public:
  explicit BodyBuilder(Graph const &graph) : graph_(&graph) {}

  NodeId leaf(Leaf leaf) {
    leaves_.push_back(std::move(leaf));
    return nodes_.intern(Node::input(static_cast<std::uint32_t>(leaves_.size() - 1)));
  }
  NodeId constant(double value) { return nodes_.constant(value); }
  // `like`: node of the graph that gives the operation its name and source location.
  NodeId operation(Op op, std::array<NodeId, 3> const &operands, NodeId like);
  void store(NodeId value, bool is_result, Access access) { stores_.push_back({value, is_result, std::move(access)}); }
  void carry(NodeId leaf, NodeId next) { leaves_[nodes_[leaf].slot()].next = next; }

  // `nest`: loop nest of the iterations, if known.
  LoopStep finish(std::uint32_t count, std::optional<Nest> const &nest = {});

private:
  Graph const *graph_;
  NodeTable nodes_;
  std::vector<NodeId> like_; // per node, or no_node
  std::vector<Leaf> leaves_;
  std::vector<Store> stores_;
};

} // namespace symreal::reroll
