// The straight-line program: what the runtime records, passes rewrite, and emitters print.
#pragma once

#include "diagnostics/diagnostic.h"
#include "graph/node.h"
#include "graph/operation_counts.h"

#include <optional>
#include <string>
#include <vector>

namespace symreal {

struct Range {
  double low, high;
};

// An annotated object: `label` is the text of its annotation, its elements occupy slots first .. first+count-1 of the
// array of its role. `extents` is empty for a scalar; otherwise their product is `count`.
struct Object {
  std::string label;
  std::vector<std::size_t> extents;
  std::uint32_t first = 0;
  std::uint32_t count = 1;
  Place place = {};
  std::optional<Range> range = {}; // inputs: where verification samples
};

// State that was read while recording and is neither input nor parameter: its value is baked into the program.
struct Frozen {
  std::string name;
  Place place;
  std::vector<double> values;
};

struct Graph {
  std::string kernel;
  std::vector<Object> inputs, parameters, outputs;

  std::vector<Node> nodes;          // topological order
  std::vector<NodeId> results;      // per output slot
  std::vector<NodeId> precomputed;  // what `preprocess` stores: slot k of `constants` holds the value of precomputed[k]
  std::vector<double> input_values; // per input slot: the value it had while recording
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

// Everything but nodes, results and precomputed: what a pass carries over unchanged.
Graph without_nodes(Graph const &graph);

// Takes results and precomputed of `graph` over, where node `id` has become `now[id]`.
void move_roots(Graph const &graph, std::vector<NodeId> const &now, Graph &result);

// Which nodes some root needs. Iterative, linear.
std::vector<char> live_nodes(Graph const &graph);

} // namespace symreal
