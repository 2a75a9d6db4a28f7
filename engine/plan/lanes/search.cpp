#include "engine/plan/lanes/search.h"

#include "engine/plan/lanes/seeds.h"

namespace symreal::lanes {

namespace {

// Least gain of a vector, to justify its code.
constexpr double least_gain = 0.5;

class Search {
public:
  explicit Search(Function const &function) : function_(function), packs_(function), cost_(cost()) {}

  Found run() {
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

  Function const &function_;
  Packs packs_;
  std::vector<Store> stores_ = {};
  double cost_;
};

} // namespace

Found search(Function const &function) { return Search(function).run(); }

} // namespace symreal::lanes
