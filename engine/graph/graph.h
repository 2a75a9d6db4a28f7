// Graph: the straight-line program that the runtime records, passes rewrite, and emitters print.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/external.h"
#include "engine/graph/node.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// Operation counts, per operation.
struct OperationCounts {
  std::array<std::size_t, static_cast<std::size_t>(Op::count)> by_op{};

  std::size_t &operator[](Op op) { return by_op[static_cast<std::size_t>(op)]; }
  std::size_t operator[](Op op) const { return by_op[static_cast<std::size_t>(op)]; }
  // Number of + - * /; negations and functions are excluded.
  std::size_t arithmetic() const { return (*this)[Op::add] + (*this)[Op::sub] + (*this)[Op::mul] + (*this)[Op::div]; }
  std::size_t calls() const {
    std::size_t sum = 0;
    for (OperationInfo const &operation : operations())
      if (operation.form == Form::call) sum += (*this)[operation.op];
    return sum;
  }
};

struct Range {
  double low, high;
};

// Member of a structure: an array of numbers, or of structures, with these extents.
struct Member {
  std::string name;
  std::vector<std::size_t> extents = {};
  std::vector<Member> members = {}; // empty: numbers
  bool operator==(Member const &) const = default;
};

// Number of doubles in an array with these extents, whose elements are numbers or structures with these members; the
// largest std::size_t on overflow.
std::size_t number_count(std::vector<std::size_t> const &extents, std::vector<Member> const &members);

// An annotated object: `label` is the text of its annotation, its numbers are slots first .. first+count-1 of the array
// of its role. `extents` is empty for a scalar.
struct Object {
  std::string label;
  std::vector<std::size_t> extents;
  std::uint32_t first = 0;
  std::uint32_t count = 1;
  Place place = {};
  std::optional<Range> range = {};  // inputs: sampling range of verification
  std::vector<Member> members = {}; // of each element, if these are structures
};

// A requested derivative, as in jacobian(tau, [q, qd]); parsed by differentiate/request.h.
struct DerivativeWish {
  std::string text;
  Place place; // empty, if an option requests it
};

// A matrix of derivatives among the outputs, with the row and column of its elements. Stored by rows.
struct DerivativeMatrix {
  std::uint32_t output = 0; // index of the output
  std::uint32_t rows = 0, columns = 0;
  // Packed: the output has exactly these elements, in this order. Otherwise it has all elements, and these are the
  // structural nonzeros.
  bool is_packed = false;
  bool is_symmetric = false; // only the half up to the diagonal is packed
  std::vector<std::uint32_t> row = {}, column = {};
};

// An input and the output that is its time derivative, by label or by the name in it; find_states resolves it.
struct StatePair {
  std::string state, derivative;
  Place place = {};
};

// State that was read while recording, besides inputs and parameters: its value is baked into the program.
struct Frozen {
  std::string name;
  Place place;
  std::vector<double> values;
  bool is_around = false;                 // a local variable of the function around a block kernel
  bool is_member = false;                 // integers of an annotated structure
  std::vector<std::uintptr_t> stack = {}; // return addresses of the first read; not part of the text form
};

// Source location of a node or a decision. At run time it consists of return addresses, innermost first; the driver
// resolves them to places: the user's own, then those further in (Eigen, std) and the inline frames.
struct Location {
  std::vector<Place> places;
  std::vector<std::uint64_t> addresses; // relative to the executable's load base; empty once resolved
};
using LocationId = std::uint32_t;
inline constexpr LocationId no_location = ~LocationId{0};

using NameId = std::uint32_t;
inline constexpr NameId no_name = ~NameId{0};

// Guard of the recorded path: the path is valid while `condition` is nonzero.
struct Guard {
  NodeId condition;
  LocationId location = no_location;
  std::string text; // the condition as text
};

// Endings of guard texts. A guard text begins with the condition, which the driver replaces by the source's wording.
inline constexpr std::string_view guard_is_false = " is false"; // the program took the other branch
inline constexpr std::string_view guard_gives = " gives ";      // of a conversion, followed by its integer
inline constexpr std::string_view guard_where = " where "; // followed by the selects' conditions under which it applies
inline constexpr std::string_view guard_of_several = "one of several paths comes by"; // of a disjunction of many paths

// Offset of the end of the condition.
inline std::size_t end_of_condition(std::string_view guard) {
  return std::min({guard.find(guard_is_false), guard.find(guard_gives), guard.find(guard_where), guard.size()});
}

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
  std::vector<DerivativeWish> wishes;     // derivatives that the program requests
  std::vector<std::string> derivatives;   // derivatives that were added, as they were requested
  bool derivatives_alone = false;         // the outputs are derivatives only: --separate
  std::vector<DerivativeMatrix> matrices; // of the derivatives, in output order

  Nodes nodes;                     // topological order
  std::vector<NodeId> results;     // per output slot
  std::vector<NodeId> precomputed; // stored by preprocess: slot k of `constants` holds precomputed[k]
  std::vector<Guard> guards;       // in the order of recording: compute returns k + 1 for the first, k, that fails
  std::string decisions = "error"; // the policy while recording, as --decisions spells it
  bool from_instructions = false;  // recorded from the instructions of the original: --record=instructions
  std::vector<Table> tables;       // of lookups, by number
  std::vector<External> externals; // of calls, by number
  NodeId last_effect = no_node;    // last of the ordered calls, each of which names its predecessor
  std::vector<Location> locations;
  LongArray<LocationId> node_location; // per node; empty if locations are not recorded
  std::vector<std::string> names;      // names of values in the source
  LongArray<NameId> node_name;         // per node, or empty
  std::vector<char> node_exact;        // per node, or empty: 1 if even mode fast keeps it as written
  std::vector<double> input_values;    // per input slot: its value while recording
  std::vector<double> parameter_values;
  std::vector<Frozen> frozen;
  OperationCounts executed; // operation counts of the recorded run, including repetitions and constant operations

  std::size_t input_count() const { return slots(inputs); }
  std::size_t parameter_count() const { return slots(parameters); }
  std::size_t output_count() const { return slots(outputs); }

private:
  static std::size_t slots(std::vector<Object> const &objects) {
    return objects.empty() ? 0 : objects.back().first + objects.back().count;
  }
};

// Indices of an input and an output.
struct State {
  std::size_t input, output;
};
// States in input order. Throws pragma_syntax if a pair names unknown objects, objects of different shapes, or one that
// another pair names.
std::vector<State> find_states(Graph const &graph);

// The first few values of a frozen state, and their number.
std::string value_list(std::vector<double> const &values);

// Severity of a frozen state under a --frozen policy; nullopt if it is only listed.
std::optional<Severity> frozen_severity(Frozen const &state, std::string const &policy);

std::string frozen_message(std::string const &kernel, Frozen const &state);

// The user's own place rather than one in a library further in; an empty place if unknown.
Place place_at(Graph const &graph, LocationId location);
Place place_of(Graph const &graph, NodeId node);

// Everything but the nodes and the references to them, which a pass keeps unchanged.
Graph without_nodes(Graph const &graph);

// Carries over all references to nodes, where node `id` of `graph` is now `now[id]` of `result`, or no_node: results,
// precomputed, guards, effects, locations, names, and exactness. An auxiliary node of a pass gets the location of the
// node that it was made for.
void carry_over(Graph const &graph, std::vector<NodeId> const &now, Graph &result);

// Removes the other nodes, in place. Operands of kept nodes, and roots, must be kept.
void keep_nodes(Graph &graph, std::vector<char> const &kept);

// Calls `visit` with every root, a node that a function must compute: results, precomputed, guards, effects.
template <class Visit> void for_each_root(Graph const &graph, Visit const &visit) {
  for (NodeId root : graph.results) visit(root);
  for (NodeId root : graph.precomputed) visit(root);
  for (Guard const &guard : graph.guards) visit(guard.condition);
  if (graph.last_effect != no_node) visit(graph.last_effect);
}

// Marks the operands of the marked nodes as well, and theirs. Iterative; linear time.
void mark_operands(Graph const &graph, std::vector<char> &marked);

// Per node: whether a root needs it.
std::vector<char> live_nodes(Graph const &graph);

// Per node: whether compute recomputes it from values that preprocess stored, independent of inputs, since that costs
// less than a load. All false until the graph is split.
std::vector<char> recomputed_nodes(Graph const &graph);

// Operands of opaque operations, whose meaning depends on tables or functions of the graph.

// Values of an argument list, first to last.
std::vector<NodeId> arguments_of(Graph const &graph, NodeId list);
inline std::size_t function_of(Graph const &graph, Node const &call) {
  return static_cast<std::size_t>(graph.nodes[call.operand[1]].value());
}
// Table number of a lookup; result number of `returned`.
inline std::size_t table_of(Graph const &graph, Node const &lookup) {
  return static_cast<std::size_t>(graph.nodes[lookup.operand[0]].value());
}
inline std::size_t result_of(Graph const &graph, Node const &returned) {
  return static_cast<std::size_t>(graph.nodes[returned.operand[1]].value());
}

} // namespace symreal
