// Plan: a graph laid out as a list of functions, each of statements, with loops in their place or vectors beside them.
// The emitters print it, and a dump shows it as text (text/plan_text.h).
#pragma once

#include "engine/graph/graph.h"
#include "engine/plan/lane_function.h"
#include "engine/plan/loop_function.h"
#include "engine/plan/value.h"

#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

namespace symreal {

// Kinds of functions, in the order of a file.
enum class FunctionKind : std::uint8_t {
  preprocess, // fills `constants`, once
  angles,     // the computed angles, for the sines and cosines with which compute begins
  compute,    // fills the outputs
};

// Effect of a guard that does not hold.
enum class GuardExit : std::uint8_t {
  none,    // the function has no guards
  returns, // it returns the guard's number, before it fills anything
};

struct FunctionInfo {
  FunctionKind kind;
  std::string_view name;
  std::span<Array const> reads; // parameters of the function; compute also reads its own sines and cosines
  Array fills;
  GuardExit guards;
  bool is_helper; // compute calls it
};
std::span<FunctionInfo const> function_kinds();
inline FunctionInfo const &info(FunctionKind kind) { return function_kinds()[static_cast<std::size_t>(kind)]; }

// Whether the function reads elements of arrays in place of nodes that are computed before it.
inline bool reads_elements(FunctionKind kind) { return kind != FunctionKind::preprocess; }

// Whether the function reads elements of the array: a parameter, or the sines and cosines with which compute begins.
bool reads(FunctionKind kind, Array array);

struct Literal {
  NodeId condition; // a node, or a gate: node count + its number
  bool holds;

  bool operator==(Literal const &) const = default;
};

using RegionId = std::uint32_t;
inline constexpr RegionId everywhere = 0; // the empty set

// Regions of a function: the conditions under which alone a statement is computed.
struct RegionTable {
  NodeId node_count = 0;
  std::vector<std::vector<Literal>> regions = {{}}; // by id, the outermost literal first; empty for `everywhere`
  std::vector<std::vector<RegionId>> gates = {};    // by number: its alternatives; empty: 1 where it is computed

  std::vector<Literal> const &literals(RegionId region) const { return regions[region]; }
  bool is_gate(NodeId condition) const { return condition >= node_count; }
  std::vector<RegionId> const &alternatives(NodeId gate) const { return gates[gate - node_count]; }
  std::size_t value_count() const { return node_count + gates.size(); } // number of nodes and gates
};

// A check before statement `before`: unless `condition` holds, the function ends as its kind says.
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

// A function. `variables` are computed in this order, one statement each; every other operation has one use and is
// nested in the expression of its user. A variable with a region is computed only there; a gate is a variable that is 1
// in its region. `results` are stored at the end, result k to slot k. Check k belongs to guard k; it comes as early as
// its operands permit, behind the checks of earlier guards; in a body of parts, behind the last part.
struct PlanFunction {
  FunctionKind kind;
  std::vector<NodeId> variables = {};
  std::vector<RegionId> region = {}; // per variable
  RegionTable regions = {};
  std::vector<Check> checks = {};
  std::vector<NodeId> results = {};
  std::set<NodeId> wanted_returns = {};           // calls of external functions whose returned value is read
  std::vector<ThreadPart> parts = {};             // empty: one thread computes all statements
  std::optional<reroll::LoopFunction> loops = {}; // replace the statements
  std::optional<lanes::LaneFunction> lanes = {};  // vector code, beside the statements
};

inline constexpr std::uint32_t no_slot = ~std::uint32_t{0};

// Sines and cosines at the start of compute (schedule/angles.h). Arrays `sine` and `cosine` have an element per angle,
// first those of inputs, then the results of function `angles`.
struct Angles {
  std::vector<std::uint32_t> inputs = {};  // slots of the angles that are inputs, in order
  std::size_t computed = 0;                // number of the other angles
  std::vector<std::uint32_t> element = {}; // per node: index in its array, or no_slot; empty if there are no angles

  std::size_t size() const { return inputs.size() + computed; }
};

// Nesting of expressions: bounded in size, or none, with a statement for every operation.
enum class Nesting { bounded, none };

struct Plan {
  Graph const *graph;
  std::vector<PlanFunction> functions;      // in the order of their kinds
  std::vector<std::uint32_t> constant_slot; // per node: slot in which preprocess stores it for compute, or no_slot
  std::size_t constant_count = 0;
  Nesting nesting = Nesting::bounded;
  unsigned threads = 1; // number of threads that share the parts of compute
  Angles angles = {};

  PlanFunction const *find(FunctionKind kind) const; // null if the plan has none
  PlanFunction &make(FunctionKind kind);             // a new one if the plan has none
  PlanFunction const &compute() const;
  PlanFunction &compute() { return make(FunctionKind::compute); }

  bool has_loops() const;
  // Vector code of a function; null if there is none.
  lanes::LaneFunction const *vectors() const;

  // Array element of a node in compute; nullopt if it is a constant or computed.
  std::optional<Element> element(NodeId id) const {
    if (constant_slot[id] != no_slot) return Element{Array::constants, constant_slot[id]};
    Node const &node = graph->nodes[id];
    if (!angles.element.empty() && angles.element[id] != no_slot)
      return Element{node.op == Op::sin ? Array::sine : Array::cosine, angles.element[id]};
    if (node.op == Op::input) return Element{Array::input, node.slot()};
    return {};
  }
  // Number of elements of an array that all functions share.
  std::size_t extent(Array array) const;
  // Kind of the value of a node or gate.
  ValueKind kind(PlanFunction const &function, NodeId id) const {
    if (function.regions.is_gate(id)) return ValueKind::truth;
    Op const op = graph->nodes[id].op;
    return is_leaf(op) ? ValueKind::f64 : kind_of(op);
  }
};

} // namespace symreal
