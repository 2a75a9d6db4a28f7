#include "engine/optimise/differentiate/addends.h"

#include <algorithm>
#include <functional>
#include <map>

namespace symreal {

namespace {

constexpr std::size_t most_overlap = 1000;
constexpr std::size_t most_steps = 8; // over all outputs, times the nodes of the graph

using Factors = std::map<NodeId, long double, std::greater<>>;

// Terms of one sum, within the shared budget `steps`; the node itself is the only term if the budget runs out.
Factors expanded(Graph const &graph, NodeId sum, std::size_t &steps) {
  Factors pending = {{sum, 1}}, terms;
  auto const constant = [&](NodeId id) { return graph.nodes[id].is_constant(); };
  auto const value = [&](NodeId id) { return static_cast<long double>(graph.nodes[id].value()); };
  while (!pending.empty()) {
    if (steps == 0) return {{sum, 1}};
    --steps;
    auto const [id, factor] = *pending.begin(); // the highest id: all its users have been expanded
    pending.erase(pending.begin());
    Node const &node = graph.nodes[id];
    NodeId const x = node.operand[0], y = node.operand[1];
    switch (node.op) {
    case Op::add: pending[x] += factor, pending[y] += factor; continue;
    case Op::sub: pending[x] += factor, pending[y] -= factor; continue;
    case Op::neg: pending[x] -= factor; continue;
    case Op::mul:
      if (constant(x)) {
        pending[y] += value(x) * factor;
        continue;
      }
      if (constant(y)) {
        pending[x] += value(y) * factor;
        continue;
      }
      break;
    case Op::div:
      if (constant(y)) {
        pending[x] += factor / value(y);
        continue;
      }
      break;
    case Op::constant:
    case Op::parameter: continue;
    default: break;
    }
    if (factor != 0) terms[id] += factor;
  }
  return terms;
}

} // namespace

Addends::Addends(Graph const &graph, std::vector<std::uint32_t> outputs) : outputs_(std::move(outputs)) {
  std::ranges::sort(outputs_);
  outputs_.erase(std::ranges::unique(outputs_).begin(), outputs_.end());
  addends_.resize(outputs_.size());
  std::vector<Factors> sums;
  std::vector<NodeId> nodes;
  std::size_t steps = most_steps * graph.nodes.size();
  for (std::uint32_t const output : outputs_) {
    sums.push_back(expanded(graph, graph.results[output], steps));
    nodes.push_back(graph.results[output]);
    for (auto const &[term, factor] : sums.back()) nodes.push_back(term);
  }
  std::ranges::sort(nodes);
  nodes.erase(std::ranges::unique(nodes).begin(), nodes.end());
  Pattern inputs = inputs_of(graph, nodes);
  auto const number_of = [&](NodeId node) {
    return static_cast<std::size_t>(std::ranges::lower_bound(nodes, node) - nodes.begin());
  };
  std::vector<std::uint32_t> number(nodes.size(), Colouring::none); // index among the terms
  for (std::size_t k = 0; k < outputs_.size(); ++k) {
    std::size_t const whole = inputs[number_of(graph.results[outputs_[k]])].size();
    std::size_t largest = 0, most = 1;
    std::vector<std::size_t> seen(graph.input_count(), 0);
    for (auto const &[term, factor] : sums[k]) {
      std::vector<std::uint32_t> const &own = inputs[number_of(term)];
      largest = std::max(largest, own.size());
      for (std::uint32_t const input : own) most = std::max(most, ++seen[input]);
    }
    // Addends that depend on as many inputs as the sum save no direction and lose precision by cancellation.
    if (2 * largest > whole || most > most_overlap) sums[k] = {{graph.results[outputs_[k]], 1}}, most = 1;
    overlap_ = std::max(overlap_, most);
    for (auto const &[term, factor] : sums[k]) {
      std::size_t const at = number_of(term);
      if (number[at] == Colouring::none) {
        number[at] = static_cast<std::uint32_t>(terms_.size());
        terms_.push_back(term);
        inputs_.push_back(inputs[at]);
      }
      addends_[k].push_back({number[at], factor});
    }
  }
}

std::vector<Addend> const &Addends::of(std::uint32_t output) const {
  auto const found = std::ranges::lower_bound(outputs_, output);
  return addends_[static_cast<std::size_t>(found - outputs_.begin())];
}

} // namespace symreal
