#include "reroll/check.h"

#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <unordered_map>

namespace symreal::reroll {

namespace {

// The number of a value and whether its sign is the other one.
struct Value {
  std::uint32_t number = ~std::uint32_t{0};
  bool negated = false;

  Value operator-() const { return {number, !negated}; }
  bool operator==(Value const &) const = default;
  bool is_known() const { return number != ~std::uint32_t{0}; }
  std::uint64_t word() const { return std::uint64_t{number} << 1 | (negated ? 1 : 0); }
};

class Numbering {
public:
  Value constant(double value) {
    std::uint64_t const bits = std::bit_cast<std::uint64_t>(std::fabs(value));
    return {number({word(Op::constant), bits, 0, 0}), std::signbit(value)};
  }
  // Of an element of an array.
  Value element(Leaf::Kind array, std::size_t index) {
    return {number({word(Op::input), static_cast<std::uint64_t>(array), index, 0}), false};
  }
  Value operation(Op op, std::array<Value, 3> operands) {
    auto &[x, y, z] = operands;
    switch (op) {
    case Op::neg: return -x;
    case Op::sub: return operation(Op::add, {x, -y, {}});
    case Op::add: order(x, y); return {number({word(op), x.word(), y.word(), 0}), false};
    case Op::mul:
    case Op::div: {
      bool const negated = x.negated != y.negated;
      x.negated = y.negated = false;
      if (op == Op::mul && x == constant(1)) return {y.number, negated};
      if (op == Op::mul && y == constant(1)) return {x.number, negated};
      if (op == Op::mul) order(x, y);
      return {number({word(op), x.word(), y.word(), 0}), negated};
    }
    default: return {number({word(op), x.word(), y.word(), z.word()}), false};
    }
  }

private:
  using Key = std::array<std::uint64_t, 4>;
  struct Hash {
    std::size_t operator()(Key const &key) const {
      std::uint64_t hash = 0;
      for (std::uint64_t part : key) hash = (std::rotl(hash, 23) ^ part) * 0x9E3779B97F4A7C15;
      return hash ^ hash >> 32;
    }
  };
  static std::uint64_t word(Op op) { return static_cast<std::uint64_t>(op); }
  static void order(Value &x, Value &y) {
    if (y.word() < x.word()) std::swap(x, y);
  }
  std::uint32_t number(Key const &key) {
    return numbers_.try_emplace(key, static_cast<std::uint32_t>(numbers_.size())).first->second;
  }

  std::unordered_map<Key, std::uint32_t, Hash> numbers_;
};

class Run {
public:
  Run(Sequence const &sequence, LoopFunction const &function, std::size_t result_count)
      : sequence_(sequence),
        memory_(function.memory),
        results_(result_count) {}

  std::string steps(std::vector<Step> const &steps) {
    for (Step const &step : steps) {
      std::vector<Value> carried(step.leaves.size());
      for (std::uint32_t k = 0; k < step.count && difference_.empty(); ++k) iteration(step, k, carried);
    }
    return difference_;
  }

  std::string compare(std::vector<NodeId> const &stored, std::vector<NodeId> const &checked,
                      std::vector<std::uint32_t> const &checks) {
    std::vector<Value> const values = values_of_graph();
    for (std::size_t slot = 0; slot < stored.size(); ++slot)
      if (results_[slot] != values[stored[slot]]) return fmt::format("result {} is another value", slot);
    if (checked.size() != checks.size()) return "a guard is not checked";
    for (std::size_t k = 0; k < checked.size(); ++k)
      if (memory_[checks[k]] != values[checked[k]]) return fmt::format("guard {} has another condition", k);
    return {};
  }

private:
  void iteration(Step const &step, std::uint32_t k, std::vector<Value> &carried) {
    Graph const &body = step.body;
    std::vector<Value> values(body.nodes.size());
    for (std::size_t id = 0; id < body.nodes.size(); ++id) {
      Node const &node = body.nodes[id];
      if (node.op == Op::input)
        values[id] = leaf(step.leaves[node.slot()], k, carried[node.slot()]);
      else if (node.is_constant())
        values[id] = numbering_.constant(node.value());
      else
        values[id] = operation(node, values);
      if (!values[id].is_known()) difference_ = fmt::format("iteration {} reads what nobody has computed", k);
    }
    for (Store const &store : step.stores) {
      std::vector<Value> &array = store.is_result ? results_ : memory_;
      has_results_ = has_results_ || store.is_result;
      array.at(store.access.at(k)) = values[store.value];
    }
    for (std::size_t slot = 0; slot < step.leaves.size(); ++slot)
      if (step.leaves[slot].kind == Leaf::Kind::carried) carried[slot] = values[step.leaves[slot].next];
  }

  Value leaf(Leaf const &leaf, std::uint32_t k, Value const &carried) {
    switch (leaf.kind) {
    case Leaf::Kind::given:
    case Leaf::Kind::read:
      if (has_results_) difference_ = "an input is read after a result is stored";
      return numbering_.element(leaf.kind, leaf.access.at(k));
    case Leaf::Kind::memory: return memory_.at(leaf.access.at(k));
    case Leaf::Kind::values: return numbering_.constant(leaf.values[k % leaf.values.size()]);
    case Leaf::Kind::carried: return k == 0 ? memory_.at(leaf.access.at(0)) : carried;
    }
    return {};
  }

  Value operation(Node const &node, std::vector<Value> const &values) {
    std::array<Value, 3> operands;
    for (std::size_t i = 0; i < arity(node.op); ++i) operands[i] = values[node.operand[i]];
    return numbering_.operation(node.op, operands);
  }

  std::vector<Value> values_of_graph() {
    Graph const &graph = *sequence_.graph;
    std::vector<Value> values(graph.nodes.size());
    for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
      Node const &node = graph.nodes[id];
      if (sequence_.slot[id] != no_slot)
        values[id] = numbering_.element(Leaf::Kind::read, sequence_.slot[id]);
      else if (node.is_constant())
        values[id] = numbering_.constant(node.value());
      else if (is_leaf(node.op))
        values[id] = numbering_.element(Leaf::Kind::given, node.slot());
      else if (sequence_.position[id] != no_position)
        values[id] = operation(node, values);
    }
    return values;
  }

  Sequence const &sequence_;
  Numbering numbering_;
  std::vector<Value> memory_, results_;
  bool has_results_ = false;
  std::string difference_;
};

} // namespace

std::string find_difference(Sequence const &sequence, LoopFunction const &function, std::vector<NodeId> const &stored,
                            std::vector<NodeId> const &checked) {
  Run run(sequence, function, stored.size());
  if (std::string difference = run.steps(function.steps); !difference.empty()) return difference;
  return run.compare(stored, checked, function.checks);
}

} // namespace symreal::reroll
