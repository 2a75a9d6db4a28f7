#include "engine/plan/lanes/search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace symreal::lanes {

// Prices in scalar operations on processors with vectors of this width: an operand in memory, scalar or vector, is
// often read by the operation itself.
namespace price {
constexpr double operation = 1, store = 1, load = 0.5, constants = 0.25;
constexpr double splat_of_element = 0.5, splat = 1;
constexpr double shuffle = 1, shuffle_of_two = 1.5;
constexpr double column = 1; // besides the transposition steps, most of which several columns share
constexpr double extract = 1, extract_first = 0.25;
} // namespace price

double Needs::cost() {
  state_.assign(function_.graph().nodes.size() + packs_.size(), State::unseen);
  windows_.clear();
  order_.clear();
  cost_ = 0;
  std::vector<char> is_stored(function_.results().size(), 0);
  for (Store const &store : stores_) {
    cost_ += price::store;
    for (std::size_t lane = 0; lane < function_.width(); ++lane) is_stored[store.first + lane] = 1;
    if (!visit(key(store.vector))) return impossible;
  }
  for (std::size_t slot = 0; slot < function_.results().size(); ++slot) {
    if (is_stored[slot]) continue;
    cost_ += price::store;
    if (!visit(function_.results()[slot])) return impossible;
  }
  for (NodeId condition : function_.conditions())
    if (!visit(condition)) return impossible;
  return cost_;
}

// Depth-first search with an explicit stack; false on a cycle.
bool Needs::visit(Key root) {
  stack_.assign(1, root);
  while (!stack_.empty()) {
    Key const key = stack_.back();
    if (state_[key] == State::unseen) {
      state_[key] = State::open;
      std::size_t const first = stack_.size();
      expand(key);
      for (std::size_t k = first; k < stack_.size(); ++k)
        if (state_[stack_[k]] == State::open) return false;
      continue;
    }
    stack_.pop_back();
    if (state_[key] != State::open) continue;
    state_[key] = State::done;
    if (is_vector(key))
      order_.push_back({true, key - this->key(0)});
    else if (function_.is_computed(key) && !packs_.place(key).is_given())
      order_.push_back({false, key});
  }
  return true;
}

void Needs::expand(Key key) {
  if (is_vector(key))
    expand_vector(key - this->key(0));
  else
    expand_node(key);
}

void Needs::expand_node(NodeId id) {
  if (!function_.is_computed(id)) return;
  if (Lane const place = packs_.place(id); place.is_given()) {
    cost_ += place.lane == 0 ? price::extract_first : price::extract;
    stack_.push_back(key(place.vector));
    return;
  }
  cost_ += price::operation;
  for (NodeId operand : function_.node(id).operand)
    if (operand != no_node) stack_.push_back(operand);
}

void Needs::expand_vector(VectorId id) {
  Packs::Pack const &pack = packs_[id];
  if (pack.is_operation) {
    cost_ += price::operation + (pack.subtracts.empty() ? 0 : price::operation);
    for (VectorId operand : pack.operand)
      if (operand != no_vector) stack_.push_back(key(operand));
    return;
  }
  Source const source = packs_.source(id);
  cost_ += price(source, pack.nodes);
  for (Source::Window const &part : source.parts)
    if (!part.is_load()) stack_.push_back(key(part.pack));
  if (source.form == Vector::Form::splat) stack_.push_back(pack.nodes[0]);
  if (source.form == Vector::Form::build && source.stride == 0)
    stack_.insert(stack_.end(), pack.nodes.begin(), pack.nodes.end());
}

double Needs::price(Source const &source, std::vector<NodeId> const &nodes) {
  double sum = 0;
  for (Source::Window const &part : source.parts) { // each window is loaded once
    if (!part.is_load() || std::ranges::find(windows_, part) != windows_.end()) continue;
    windows_.push_back(part);
    sum += price::load;
  }
  switch (source.form) {
  case Vector::Form::constants: return price::constants;
  case Vector::Form::splat: return function_.is_computed(nodes[0]) ? price::splat : price::splat_of_element;
  case Vector::Form::load: return sum;
  case Vector::Form::shuffle: return sum + (source.parts.size() == 1 ? price::shuffle : price::shuffle_of_two);
  default: break;
  }
  double const width = static_cast<double>(nodes.size());
  return source.stride != 0 ? price::column + std::log2(width) : width;
}

namespace {

enum class Depth { whole, few };

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  hash = (std::rotl(hash, 23) ^ word) * 0x9E3779B97F4A7C15;
  return hash ^ hash >> 32;
}

// Per node: hash of its shape, and sum of the indices that it reads.
class Shapes {
public:
  // Shapes of whole expressions, or of a few levels of operations.
  Shapes(ScalarFunction const &function, Depth depth) : function_(function), count_(function.graph().nodes.size()) {
    shape.resize(count_);
    place.resize(count_, 0);
    for (NodeId id = 0; id < count_; ++id)
      if (function.is_computed(id))
        shape[id] = 4;
      else
        set_leaf(id);
    if (depth == Depth::whole) deepen(shape, place);
    for (int k = 0; depth == Depth::few && k < few; ++k) deepen(std::vector(shape), std::vector(place));
  }

  std::vector<std::uint64_t> shape, place;

private:
  static constexpr int few = 3;

  void set_leaf(NodeId id) {
    bool const is_element = function_.is_element(id);
    shape[id] = is_element ? 2 + static_cast<std::uint64_t>(function_.element(id).array) : 1;
    if (is_element) place[id] = function_.element(id).index;
  }

  // Extends the shapes by those of the operands, which may be updated in place.
  void deepen(std::vector<std::uint64_t> const &shapes, std::vector<std::uint64_t> const &places) {
    for (NodeId id = 0; id < count_; ++id) {
      if (!function_.is_computed(id)) continue;
      Node const &node = function_.node(id);
      std::uint64_t hash = mixed(5, static_cast<std::uint64_t>(node.op == Op::sub ? Op::add : node.op)), sum = 0;
      std::vector<std::uint64_t> operands;
      for (unsigned i = 0; i < arity(node.op); ++i) {
        operands.push_back(shapes[node.operand[i]]);
        sum += places[node.operand[i]];
      }
      if (node.op == Op::add || node.op == Op::mul || node.op == Op::sub) std::ranges::sort(operands);
      for (std::uint64_t operand : operands) hash = mixed(hash, operand);
      shape[id] = hash;
      place[id] = sum;
    }
  }

  ScalarFunction const &function_;
  std::size_t count_;
};

// Groups of at least `width` of these nodes with the same expression, whole or a few operations deep: in the order of
// nodes and, if it differs, in the order of the elements that they read.
std::vector<std::vector<std::vector<NodeId>>> alike(ScalarFunction const &function, std::vector<NodeId> const &nodes,
                                                    Depth depth) {
  Shapes const shapes(function, depth);
  std::map<std::uint64_t, std::size_t> number; // of a shape, in order of its first node
  std::vector<std::vector<NodeId>> groups;
  for (NodeId id : nodes) {
    if (!function.can_be_packed(id)) continue;
    auto const [at, is_new] = number.try_emplace(shapes.shape[id], groups.size());
    if (is_new) groups.emplace_back();
    groups[at->second].push_back(id);
  }
  std::vector<std::vector<std::vector<NodeId>>> result;
  for (std::vector<NodeId> const &group : groups) {
    if (group.size() < function.width()) continue;
    result.push_back({group});
    std::ranges::sort(result.back()[0]);
    std::vector<NodeId> by_place = result.back()[0];
    std::ranges::stable_sort(by_place, {}, [&](NodeId id) { return shapes.place[id]; });
    if (by_place != result.back()[0]) result.back().push_back(std::move(by_place));
  }
  return result;
}

// Least gain of a vector, to justify its code.
constexpr double least_gain = 0.5;

class VectorSearch {
public:
  explicit VectorSearch(ScalarFunction const &function) : function_(function), packs_(function), cost_(cost()) {}

  VectorChoice run() {
    store_results();
    for (Depth const depth : {Depth::whole, Depth::few})
      for (bool gains = true; gains;) {
        double const before = cost_;
        for (auto const &orders : alike(function_, alone(), depth)) pack_group(orders);
        gains = before - cost_ >= least_gain;
      }
    for (double before = Needs::impossible; cost_ < before;) {
      before = cost_;
      for (std::size_t id = packs_.size(); id-- > 0;) cost_ = trim(static_cast<VectorId>(id), cost_);
    }
    return {std::move(packs_), std::move(stores_)};
  }

private:
  double cost() const { return Needs(function_, packs_, stores_).cost(); }

  // Scalar operations, the last first, so that their operands may be packed with them.
  std::vector<NodeId> alone() const {
    Needs needs(function_, packs_, stores_);
    needs.cost();
    std::vector<NodeId> nodes;
    for (NodeId id = static_cast<NodeId>(function_.graph().nodes.size()); id-- > 0;)
      if (function_.is_computed(id) && needs.is_alone(id)) nodes.push_back(id);
    return nodes;
  }

  void store_results() {
    std::vector<NodeId> const &results = function_.results();
    std::size_t const width = function_.width();
    for (std::size_t slot = 0; slot + width <= results.size();) {
      auto const first = results.begin() + static_cast<std::ptrdiff_t>(slot);
      slot += try_vector({first, first + static_cast<std::ptrdiff_t>(width)}, slot) ? width : 1;
    }
  }

  // Packs a group in the order with the greatest gain.
  void pack_group(std::vector<std::vector<NodeId>> const &orders) {
    std::size_t const size = packs_.size();
    double const before = cost_;
    std::vector<double> after;
    for (std::vector<NodeId> const &order : orders) {
      pack_windows(order);
      after.push_back(cost_);
      if (orders.size() == 1) return;
      packs_.cut(size);
      cost_ = before;
    }
    pack_windows(orders[after[1] < after[0] ? 1 : 0]);
  }

  void pack_windows(std::vector<NodeId> const &order) {
    std::size_t const width = function_.width();
    for (std::size_t first = 0; first + width <= order.size();) {
      std::vector<NodeId> const nodes(order.begin() + static_cast<std::ptrdiff_t>(first),
                                      order.begin() + static_cast<std::ptrdiff_t>(first + width));
      bool is_free = true;
      for (NodeId id : nodes) is_free = is_free && !packs_.place(id).is_given();
      first += is_free && try_vector(nodes, no_slot) ? width : 1;
    }
  }

  bool try_vector(std::vector<NodeId> const &nodes, std::size_t slot) {
    std::size_t const size = packs_.size();
    VectorId const id = packs_.grow(nodes);
    if (slot != no_slot) stores_.push_back({id, slot});
    double cost = this->cost();
    for (std::size_t last = packs_.size(); last-- > size;) cost = trim(static_cast<VectorId>(last), cost);
    if (cost_ - cost >= least_gain) {
      cost_ = cost;
      return true;
    }
    packs_.cut(size);
    if (slot != no_slot) stores_.pop_back();
    return false;
  }

  // Unpacks an operation that costs more as a vector than as scalars.
  double trim(VectorId id, double cost) {
    Packs::Pack const &pack = packs_[id];
    if (!pack.is_operation) return cost;
    for (VectorId operand : pack.operand) // its operands would be taken apart again
      if (operand != no_vector && packs_[operand].is_operation) return cost;
    packs_.set_operation(id, false);
    if (double const less = this->cost(); less < cost) return less;
    packs_.set_operation(id, true);
    return cost;
  }

  ScalarFunction const &function_;
  Packs packs_;
  std::vector<Store> stores_ = {};
  double cost_;
};

} // namespace

VectorChoice search(ScalarFunction const &function) { return VectorSearch(function).run(); }

} // namespace symreal::lanes
