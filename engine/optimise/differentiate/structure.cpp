#include "engine/optimise/differentiate/structure.h"

#include "engine/optimise/differentiate/rules.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <map>
#include <numeric>

namespace symreal {

namespace {

using Bits = std::uint64_t;
constexpr std::size_t width = 64;

std::size_t block_count(Graph const &graph) { return (graph.input_count() + width - 1) / width; }

// Bit set per node: the inputs of one block that it depends on.
std::vector<Bits> dependence(Graph const &graph, std::size_t block) {
  std::vector<Bits> bits(graph.nodes.size(), 0);
  for (std::size_t id = 0; id < bits.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (node.op == Op::input && node.slot() / width == block) bits[id] = Bits{1} << node.slot() % width;
    for (std::size_t i = 0; i < arity(node.op); ++i)
      if (node.operand[i] != no_node) bits[id] |= bits[node.operand[i]];
  }
  return bits;
}

template <class Visit> void for_each_bit(Bits bits, Visit const &visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

enum class Bend : std::uint8_t { none, product, quotient, all };

// Operand pairs with a nonzero second derivative. Operations that are linear between kinks have no such pair.
Bend bend_of(Op op) {
  switch (op) {
  case Op::add:
  case Op::sub:
  case Op::neg:
  case Op::abs:
  case Op::fmin:
  case Op::fmax:
  case Op::fdim:
  case Op::select: return Bend::none;
  case Op::mul: return Bend::product;
  case Op::div: return Bend::quotient;
  default: break;
  }
  if (info(op).has(flag::OPAQUE)) return Bend::all; // a program function
  for (std::size_t i = 0; i < arity(op); ++i)
    if (slope_of(op, i) == Slope::formula) return Bend::all;
  return Bend::none;
}

std::vector<char> needed_by(Graph const &graph, std::span<NodeId const> nodes) {
  std::vector<char> needed(graph.nodes.size(), 0);
  for (NodeId const node : nodes) needed[node] = 1;
  for (std::size_t id = needed.size(); id-- > 0;)
    for (std::size_t i = 0; needed[id] && i < arity(graph.nodes[id].op); ++i)
      if (NodeId const operand = graph.nodes[id].operand[i]; operand != no_node) needed[operand] = 1;
  return needed;
}

// Bit matrix, stored by rows of 64-bit blocks.
class BitMatrix {
public:
  BitMatrix(std::size_t size, std::size_t blocks) : blocks_(blocks), bits_(size * blocks, 0) {}
  void add(std::size_t row, std::size_t block, Bits columns) { bits_[row * blocks_ + block] |= columns; }
  Pattern pattern() const {
    Pattern rows(blocks_ == 0 ? 0 : bits_.size() / blocks_);
    for (std::size_t row = 0; row < rows.size(); ++row)
      for (std::size_t block = 0; block < blocks_; ++block)
        for_each_bit(bits_[row * blocks_ + block],
                     [&](std::size_t k) { rows[row].push_back(static_cast<std::uint32_t>(block * width + k)); });
    return rows;
  }

private:
  std::size_t blocks_;
  std::vector<Bits> bits_;
};

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

Pattern inputs_of(Graph const &graph, std::span<NodeId const> nodes) {
  Pattern rows(nodes.size());
  for (std::size_t block = 0; block < block_count(graph); ++block) {
    std::vector<Bits> const bits = dependence(graph, block);
    for (std::size_t row = 0; row < rows.size(); ++row)
      for_each_bit(bits[nodes[row]],
                   [&](std::size_t k) { rows[row].push_back(static_cast<std::uint32_t>(block * width + k)); });
  }
  return rows;
}

Pattern coupled_inputs(Graph const &graph, std::span<NodeId const> nodes) {
  std::size_t const blocks = block_count(graph);
  std::vector<char> const needed = needed_by(graph, nodes);
  BitMatrix coupled(graph.input_count(), blocks);
  for (std::size_t left = 0; left < blocks; ++left) {
    std::vector<Bits> const rows = dependence(graph, left);
    for (std::size_t right = 0; right < blocks; ++right) {
      std::vector<Bits> const other = right == left ? std::vector<Bits>() : dependence(graph, right);
      std::vector<Bits> const &columns = right == left ? rows : other;
      auto const join = [&](Bits of_row, Bits of_column) {
        for_each_bit(of_row, [&](std::size_t k) { coupled.add(left * width + k, right, of_column); });
      };
      for (std::size_t id = 0; id < needed.size(); ++id) {
        Node const &node = graph.nodes[id];
        if (!needed[id] || is_leaf(node.op) || rows[id] == 0 || columns[id] == 0) continue;
        NodeId const x = node.operand[0], y = node.operand[1];
        switch (bend_of(node.op)) {
        case Bend::none: break;
        case Bend::quotient: join(rows[y], columns[y]); [[fallthrough]];
        case Bend::product: join(rows[x], columns[y]), join(rows[y], columns[x]); break;
        case Bend::all: join(rows[id], columns[id]); break;
        }
      }
    }
  }
  return coupled.pattern();
}

Colouring coloured(Pattern const &rows, std::size_t columns) {
  Pattern rows_of(columns);
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::uint32_t const column : rows[row]) rows_of[column].push_back(static_cast<std::uint32_t>(row));
  std::vector<std::uint32_t> order(columns);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater(), [&](std::uint32_t column) { return rows_of[column].size(); });
  Colouring colouring{std::vector<std::uint32_t>(columns, Colouring::none), 0};
  std::vector<std::vector<Bits>> taken(rows.size()); // per row, a bit set of colours
  for (std::uint32_t const column : order) {
    if (rows_of[column].empty()) continue;
    std::vector<Bits> all;
    for (std::uint32_t const row : rows_of[column]) {
      all.resize(std::max(all.size(), taken[row].size()), 0);
      for (std::size_t k = 0; k < taken[row].size(); ++k) all[k] |= taken[row][k];
    }
    std::size_t word = 0;
    while (word < all.size() && ~all[word] == 0) ++word;
    std::size_t const bit = word == all.size() ? 0 : static_cast<std::size_t>(std::countr_one(all[word]));
    for (std::uint32_t const row : rows_of[column]) {
      taken[row].resize(std::max(taken[row].size(), word + 1), 0);
      taken[row][word] |= Bits{1} << bit;
    }
    colouring.colour[column] = static_cast<std::uint32_t>(word * width + bit);
    colouring.count = std::max(colouring.count, word * width + bit + 1);
  }
  return colouring;
}

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
