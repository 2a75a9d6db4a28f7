#include "engine/plan/lanes/needs.h"

#include <algorithm>
#include <cmath>

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
  for (Source::Part const &part : source.parts)
    if (!part.is_load()) stack_.push_back(key(part.pack));
  if (source.form == Vector::Form::splat) stack_.push_back(pack.nodes[0]);
  if (source.form == Vector::Form::build && source.stride == 0)
    stack_.insert(stack_.end(), pack.nodes.begin(), pack.nodes.end());
}

double Needs::price(Source const &source, std::vector<NodeId> const &nodes) {
  double sum = 0;
  for (Source::Part const &part : source.parts) { // each window is loaded once
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

} // namespace symreal::lanes
