// The straight-line program: what the runtime records, passes rewrite, and emitters print.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/external.h"
#include "engine/graph/node.h"
#include "engine/graph/operation_counts.h"

#include <optional>
#include <string>
#include <vector>

namespace symreal {

struct Range {
  double low, high;
};

// Of a structure: numbers, or structures again, `extents` many.
struct Member {
  std::string name;
  std::vector<std::size_t> extents = {};
  std::vector<Member> members = {}; // none: numbers
  bool operator==(Member const &) const = default;
};

// How many numbers there are in an array of this, or of these members one after the other; the largest std::size_t if
// more.
std::size_t number_count(std::vector<std::size_t> const &extents, std::vector<Member> const &members);

// An annotated object: `label` is the text of its annotation, its numbers occupy slots first .. first+count-1 of the
// array of its role. `extents` is empty where it is no array.
struct Object {
  std::string label;
  std::vector<std::size_t> extents;
  std::uint32_t first = 0;
  std::uint32_t count = 1;
  Place place = {};
  std::optional<Range> range = {};  // inputs: where verification samples
  std::vector<Member> members = {}; // of each element, if these are structures
};

// A derivative that is asked for, as in jacobian(tau, [q, qd]): differentiate/request.h reads it.
struct DerivativeWish {
  std::string text;
  Place place; // nowhere, if an option asks for it
};

// An output that is a matrix of derivatives: which element each pair of a row and a column is. Row by row.
struct DerivativeMatrix {
  std::uint32_t output = 0; // its number
  std::uint32_t rows = 0, columns = 0;
  // Packed: the output holds these elements alone, in this order. Otherwise it holds all of them, and these are the
  // ones that are not zero by structure.
  bool is_packed = false;
  bool is_symmetric = false; // nothing above the diagonal is packed: it is what stands below
  std::vector<std::uint32_t> row = {}, column = {};
};

// An input and the output that is its derivative by time, by their labels or the names in these; states.h finds them.
struct StatePair {
  std::string state, derivative;
  Place place = {};
};

// State that was read while recording and is neither input nor parameter: its value is baked into the program.
struct Frozen {
  std::string name;
  Place place;
  std::vector<double> values;
  bool is_around = false;                 // a local of the function around a block kernel
  bool is_member = false;                 // integers of a structure that is annotated
  std::vector<std::uintptr_t> stack = {}; // return addresses of the first read, which the text does not keep
};

// Where in the program a node or a decision comes from. While a program runs only return addresses are known, innermost
// first; the driver turns them into places: the user's own, then those further in (Eigen, std) and the inline frames.
struct Location {
  std::vector<Place> places;
  std::vector<std::uint64_t> addresses; // relative to the executable's load base; empty once resolved
};
using LocationId = std::uint32_t;
inline constexpr LocationId no_location = ~LocationId{0};

using NameId = std::uint32_t;
inline constexpr NameId no_name = ~NameId{0};

// What the recorded path rests on: the program decided as it did because `condition` is not 0.
struct Guard {
  NodeId condition;
  LocationId location = no_location;
  std::string text; // the condition in words
};

struct Graph {
  Graph();
  Graph(Graph const &);
  Graph(Graph &&) noexcept;
  Graph &operator=(Graph const &);
  Graph &operator=(Graph &&) noexcept;
  ~Graph();

  std::string kernel;
  std::vector<Object> inputs, parameters, outputs;
  std::vector<StatePair> states;
  std::vector<DerivativeWish> wishes;     // derivatives that the program asks for
  std::vector<std::string> derivatives;   // those that were added, as they were asked for
  bool derivatives_alone = false;         // the outputs are derivatives only: --separate
  std::vector<DerivativeMatrix> matrices; // of them, in the order of their outputs

  Nodes nodes;                     // topological order
  std::vector<NodeId> results;     // per output slot
  std::vector<NodeId> precomputed; // what `preprocess` stores: slot k of `constants` holds the value of precomputed[k]
  std::vector<Guard> guards;       // in the order of recording: compute returns k + 1 for the first, k, that fails
  std::string decisions = "error"; // the policy while recording, as --decisions spells it
  bool from_instructions = false;  // recorded from the instructions of the original: --via-ir
  std::vector<Table> tables;       // what lookups read, by number
  std::vector<External> externals; // what calls call, by number
  NodeId last_effect = no_node;    // of the calls in order, each of which names the one before it
  std::vector<Location> locations;
  LongArray<LocationId> node_location; // per node, or empty: places were not asked for
  std::vector<std::string> names;      // what the source calls its numbers
  LongArray<NameId> node_name;         // per node, or empty
  std::vector<char> node_exact;        // per node, or empty: 1 where even mode fast keeps it as it is written
  std::vector<double> input_values;    // per input slot: the value it had while recording
  std::vector<double> parameter_values;
  std::vector<Frozen> frozen;
  OperationCounts executed; // by the program while it was recorded, repetitions and work on constants included

  std::size_t input_count() const { return slots(inputs); }
  std::size_t parameter_count() const { return slots(parameters); }
  std::size_t output_count() const { return slots(outputs); }

private:
  static std::size_t slots(std::vector<Object> const &objects) {
    return objects.empty() ? 0 : objects.back().first + objects.back().count;
  }
};

// The user's own place, not one of a library further in; nowhere, where none is known.
Place place_at(Graph const &graph, LocationId location);
Place place_of(Graph const &graph, NodeId node);

// Everything but nodes and what names them: what a pass carries over unchanged.
Graph without_nodes(Graph const &graph);

// Takes over what names the nodes of `graph`, where node `id` has become `now[id]` of `result`, or no_node: results,
// precomputed, guards, effects, locations, names, and what is exact. A node that a pass made on the way to another has
// that one's location.
void carry_over(Graph const &graph, std::vector<NodeId> const &now, Graph &result);

// Drops the nodes that are not kept, in place. What a kept node or a root needs must be kept.
void keep_nodes(Graph &graph, std::vector<char> const &kept);

// Calls `visit` with every node that a function of the program must compute: results, precomputed, guards, effects.
template <class Visit> void for_each_root(Graph const &graph, Visit const &visit) {
  for (NodeId root : graph.results) visit(root);
  for (NodeId root : graph.precomputed) visit(root);
  for (Guard const &guard : graph.guards) visit(guard.condition);
  if (graph.last_effect != no_node) visit(graph.last_effect);
}

// Which nodes some root needs. Iterative, linear.
std::vector<char> live_nodes(Graph const &graph);

// Which operations function `compute` does on what `preprocess` has stored alone: they depend on no input, and cost
// less than a load. None as long as the graph is not split.
std::vector<char> recomputed_nodes(Graph const &graph);

} // namespace symreal
