// Schedule: a graph laid out as the statements of two functions; the input of the emitters.
#pragma once

#include "engine/graph/graph.h"
#include "engine/plan/schedule/regions.h"

#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace symreal {

// A check before statement `before`: the function returns unless `condition` holds.
struct Check {
  NodeId condition;
  std::size_t before;
};

// Statements that one thread computes, from the end of the previous part on. Parts of one stage run concurrently,
// stages one after the other.
struct ThreadPart {
  std::uint32_t stage;
  std::size_t end;
};

// A function body. `variables` are computed in this order, one statement each; every other operation has one use and is
// nested in the expression of its user. A variable with a region is computed only there; a gate is a variable that is 1
// in its region. `results` are stored at the end, result k to slot k. Check k belongs to guard k; it comes as early as
// its operands permit, behind the checks of earlier guards; in a body of parts, behind the last part.
struct FunctionBody {
  std::vector<NodeId> variables = {};
  std::vector<RegionId> region = {}; // per variable
  RegionTable regions = {};
  std::vector<Check> checks = {};
  std::vector<NodeId> results = {};
  std::set<NodeId> wanted_returns = {}; // calls of external functions whose returned value is read
  std::vector<ThreadPart> parts = {};   // empty: one thread computes all statements
};

// Statements per part of a long function, unless its language sets another limit; longer bodies are cut.
inline constexpr std::size_t usual_part_length = 500;

inline constexpr std::uint32_t no_slot = ~std::uint32_t{0};

// Arrays that compute reads nodes from.
enum class Array : std::uint8_t { input, constants, sine, cosine };
struct Element {
  Array array;
  std::size_t index;
};
std::string_view name_of(Array array);

// Sines and cosines at the start of compute (angles.h). Arrays `sine` and `cosine` have an element per angle, first
// those of inputs, then the computed angles.
struct Angles {
  std::vector<std::uint32_t> inputs = {}; // slots of the angles that are inputs, in order
  FunctionBody computed = {}; // its results are the other angles; it reads what compute reads, except sines and cosines
  std::vector<std::uint32_t> element = {}; // per node: index in its array, or no_slot; empty if there are no angles

  std::size_t size() const { return inputs.size() + computed.results.size(); }
};

// Nesting of expressions: bounded in size, or none, with a statement for every operation.
enum class Nesting { bounded, none };

struct Schedule {
  Graph const *graph;
  FunctionBody preprocess, compute;
  std::vector<std::uint32_t> constant_slot; // per node: slot in which preprocess stores it for compute, or no_slot
  std::size_t constant_count = 0;
  Nesting nesting = Nesting::bounded;
  unsigned threads = 1; // number of threads that share the parts of compute
  Angles angles = {};

  // Array element of a node in compute; nullopt if it is a constant or computed.
  std::optional<Element> element(NodeId id) const {
    if (constant_slot[id] != no_slot) return Element{Array::constants, constant_slot[id]};
    Node const &node = graph->nodes[id];
    if (!angles.element.empty() && angles.element[id] != no_slot)
      return Element{node.op == Op::sin ? Array::sine : Array::cosine, angles.element[id]};
    if (node.op == Op::input) return Element{Array::input, node.slot()};
    return {};
  }
};

// Slots of `constants`: per node the last slot that stores it, or no_slot.
std::vector<std::uint32_t> constant_slots(Graph const &graph, std::vector<NodeId> const &stored);

// Whether the operands of a select's arms are computed in blocks under the condition, or always.
enum class Arms { in_blocks, computed };

// Statements keep the order of recording; if that needs more registers than there are, list scheduling replaces it
// where that spills fewer values. Conditional operations follow their condition. `graph` must outlive the schedule.
Schedule schedule(Graph const &graph, Nesting nesting = Nesting::bounded, Arms arms = Arms::in_blocks);

// Layout of an extra function that reads the same arrays as compute.
FunctionBody lay_out(Graph const &graph, std::vector<NodeId> const &results,
                     std::vector<std::uint32_t> const &constant_slot, Nesting nesting);

inline constexpr unsigned most_threads = 64;

// Stage and thread that execute a statement of compute.
struct Share {
  std::uint32_t stage = 0, thread = 0;
};

// Sorts the statements of compute by stage and thread, stably. `shares`: per statement. No statement may
// precede its operands in that order.
Schedule shared_out(Schedule const &plan, std::vector<Share> const &shares, unsigned threads);

} // namespace symreal
