#include "program/record/oracle.h"

#include "engine/graph/evaluate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace symreal::program {
namespace {

bool is_operation(Node const &node) { return !is_leaf(node.op); }

std::size_t count_operations(Graph const &graph) {
  return static_cast<std::size_t>(std::count_if(graph.nodes.begin(), graph.nodes.end(), is_operation));
}

std::string line_of(Graph const &graph, NodeId id) {
  Place const place = place_of(graph, id);
  return place.file.empty() ? "" : fmt::format("{}:{}", place.file, place.line);
}

// Values of a node on a few samples; operations with equal values count as equal.
using Values = std::vector<std::uint64_t>;

class ValuesOfNodes {
public:
  static constexpr std::size_t most_samples = 4;

  void add(std::vector<double> const &values, std::vector<char> const &active) {
    if (samples_++ == 0) {
      values_.resize(values.size());
      active_.resize(values.size());
    }
    for (NodeId id = 0; id < values.size(); ++id) {
      values_[id].push_back(std::bit_cast<std::uint64_t>(std::fabs(values[id]))); // absolute: clang moves signs
      active_[id] |= active[id];
    }
  }
  bool is_full() const { return samples_ == most_samples; }
  std::set<Values> all() const { return {values_.begin(), values_.end()}; }
  // Counts the active operations whose values are not among `known`, by source line.
  std::map<std::string, std::size_t> others(Graph const &graph, std::set<Values> const &known) const {
    std::map<std::string, std::size_t> lines;
    for (NodeId id = 0; id < values_.size(); ++id)
      if (active_[id] && is_operation(graph.nodes[id]) && !known.contains(values_[id])) ++lines[line_of(graph, id)];
    return lines;
  }

private:
  std::size_t samples_ = 0;
  std::vector<Values> values_;
  std::vector<char> active_;
};

// Evaluator of one recording, sample by sample.
class Side {
public:
  Side(Graph const &graph, FloatingPoint mode) : graph_(graph), mode_(mode) {}

  // Does the sample satisfy the premises and all guards?
  bool evaluate(Sample const &sample) {
    values_ = symreal::evaluate(graph_, sample.inputs, sample.parameters);
    evaluation_ = evaluation_of(graph_, values_);
    return evaluation_.premises.hold_in(mode_) && evaluation_.failing_guard == graph_.guards.size();
  }
  void keep_values() {
    if (!kept_.is_full()) kept_.add(values_, active_nodes(graph_, values_));
  }
  std::vector<double> const &outputs() const { return evaluation_.outputs; }
  ValuesOfNodes const &kept() const { return kept_; }

private:
  Graph const &graph_;
  FloatingPoint mode_;
  std::vector<double> values_;
  Evaluation evaluation_{};
  ValuesOfNodes kept_;
};

void require_shape(Graph const &graph, Graph const &oracle) {
  if (graph.input_count() != oracle.input_count() || graph.parameter_count() != oracle.parameter_count() ||
      graph.output_count() != oracle.output_count())
    fail(DiagnosticId::oracle_mismatch, graph.outputs.front().place,
         fmt::format("kernel '{}' has {} inputs, {} parameters and {} outputs, its oracle {}, {} and {}", graph.kernel,
                     graph.input_count(), graph.parameter_count(), graph.output_count(), oracle.input_count(),
                     oracle.parameter_count(), oracle.output_count()));
}

constexpr int most_steps = 8;
void approach(std::vector<double> &values, std::vector<double> const &target) {
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = target[k] + (values[k] - target[k]) / 8;
}

} // namespace

Recording record_instructions(Front const &front, RunOptions run, LineSink const &sink) {
  require_instructions(front.rewritten);
  for (Recorded const &one : front.kernels)
    if (calls_program(one.graph))
      fail(DiagnosticId::oracle_not_possible, one.graph.outputs.front().place,
           fmt::format("kernel '{}' calls functions of the program, which cannot be evaluated without it",
                       one.graph.kernel));
  rewrite::Result annotated = rewrite::annotated_original(front.rewritten);
  Overlay const overlay(annotated, front.workspace->directory("annotated-oracle"));
  std::array const variants = {Variant::recorded};
  std::string const executable =
      build_variants(front.build, variants, *front.overlay, overlay, *front.workspace).front();
  run.decisions = "guard";
  return record(executable, run_of(front, std::move(run)), annotated, front.wanted, overlay, *front.workspace, sink);
}

OracleComparison compare_recordings(Graph const &graph, Graph const &oracle, OracleOptions const &options) {
  require_shape(graph, oracle);
  OracleComparison result;
  result.operations = count_operations(graph);
  result.oracle_operations = count_operations(oracle);
  result.outputs.resize(graph.output_count());
  Side recorded(graph, options.mode), by_oracle(oracle, options.mode);
  auto const are_inside = [&](Sample const &sample) { return recorded.evaluate(sample) && by_oracle.evaluate(sample); };
  SampleSource source(graph, options.seed);
  Sample const first = source.next();
  for (std::size_t k = 0; k < options.samples; ++k) {
    Sample sample = k == 0 ? first : source.next();
    bool is_inside = are_inside(sample);
    // Moves towards the recorded sample, where more guards hold.
    for (int step = 0; step < most_steps && !is_inside && !oracle.guards.empty(); ++step) {
      approach(sample.inputs, first.inputs);
      approach(sample.parameters, first.parameters);
      is_inside = are_inside(sample);
    }
    if (!is_inside) {
      ++result.outside;
      continue;
    }
    ++result.samples;
    recorded.keep_values();
    by_oracle.keep_values();
    for (std::size_t slot = 0; slot < result.outputs.size(); ++slot)
      result.outputs[slot].add(k, by_oracle.outputs()[slot], recorded.outputs()[slot], options.mode, 0);
  }
  result.only_oracle = by_oracle.kept().others(oracle, recorded.kept().all());
  return result;
}

} // namespace symreal::program
