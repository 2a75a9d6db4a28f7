// A graph laid out as two functions of statements: what an emitter prints.
#pragma once

#include "engine/graph/graph.h"
#include "engine/plan/schedule/region_table.h"

#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace symreal {

// Stands before statement `before`: the function returns unless `condition` holds.
struct Check {
  NodeId condition;
  std::size_t before;
};

// Statements that one thread computes, from the end of the part before on. Parts of one stage are computed at the same
// time, stages one after the other.
struct ThreadPart {
  std::uint32_t stage;
  std::size_t end;
};

// A function body: `variables` are computed in this order, one statement each; every other operation is used once and
// is nested in its user's expression. A variable with a region is computed only there; a gate is a variable too, which
// is 1 in its region. `results` are stored at the end, result k to slot k. Check k is that of guard k; it stands as
// early as its condition can be computed and not before that of an earlier guard; in a body of parts behind the last
// one.
struct FunctionBody {
  std::vector<NodeId> variables = {};
  std::vector<RegionId> region = {}; // per variable
  RegionTable regions = {};
  std::vector<Check> checks = {};
  std::vector<NodeId> results = {};
  std::set<NodeId> wanted_returns = {}; // the calls of external functions whose returned value is read
  std::vector<ThreadPart> parts = {};   // none: one thread computes all of it
};

// Statements of a part of a long function, where its language says nothing else: longer bodies are cut.
inline constexpr std::size_t usual_part_length = 500;

inline constexpr std::uint32_t no_slot = ~std::uint32_t{0};

// What compute finds in arrays and does not compute.
enum class Array : std::uint8_t { input, constants, sine, cosine };
struct Element {
  Array array;
  std::size_t index;
};
std::string_view name_of(Array array);

// What compute begins with (angles.h): sines and cosines. Arrays `sine` and `cosine` have an element for each angle,
// first the inputs, then what is computed.
struct Angles {
  std::vector<std::uint32_t> inputs = {};  // their slots, in order
  FunctionBody computed = {};              // its results are angles; it reads what compute reads, but no sines
  std::vector<std::uint32_t> element = {}; // per node: of its array, or no_slot; empty where there are no angles

  std::size_t size() const { return inputs.size() + computed.results.size(); }
};

// Whether expressions nest, or every operation is a statement of its own.
enum class Nesting { bounded, none };

struct Schedule {
  Graph const *graph;
  FunctionBody preprocess, compute;
  std::vector<std::uint32_t> constant_slot; // per node: where preprocess stores it for compute, or no_slot
  std::size_t constant_count = 0;
  Nesting nesting = Nesting::bounded;
  unsigned threads = 1; // that share the parts of compute
  Angles angles = {};

  // Where compute finds a node, unless it is a constant or is computed.
  std::optional<Element> element(NodeId id) const {
    if (constant_slot[id] != no_slot) return Element{Array::constants, constant_slot[id]};
    Node const &node = graph->nodes[id];
    if (!angles.element.empty() && angles.element[id] != no_slot)
      return Element{node.op == Op::sin ? Array::sine : Array::cosine, angles.element[id]};
    if (node.op == Op::input) return Element{Array::input, node.slot()};
    return {};
  }
};

// What `constants` holds for compute: per node its slot, the last one that stores it, or no_slot.
std::vector<std::uint32_t> constant_slots(Graph const &graph, std::vector<NodeId> const &stored);

// Whether what one arm of a select needs waits for the condition, or is computed in any case.
enum class Arms { in_blocks, computed };

// The order of statements is the order of recording, or that of list scheduling where more values live than there are
// registers and it keeps fewer waiting. What is computed under a condition waits for the condition. `graph` must
// outlive the program.
Schedule schedule(Graph const &graph, Nesting nesting = Nesting::bounded, Arms arms = Arms::in_blocks);

// Of a function beside compute, which finds in arrays what that does.
FunctionBody lay_out(Graph const &graph, std::vector<NodeId> const &results,
                     std::vector<std::uint32_t> const &constant_slot, Nesting nesting);

} // namespace symreal
