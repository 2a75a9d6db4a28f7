#include "engine/optimise/passes/min_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace symreal {

namespace {

using Flow = std::int64_t;
constexpr Flow unlimited = std::numeric_limits<Flow>::max() / 4;

// Dinic's maximum flow: augments along all shortest paths of one length at once. Iterative, since paths are long.
class FlowNetwork {
public:
  explicit FlowNetwork(std::size_t nodes) : first_(nodes, none) {}

  void add(std::uint32_t from, std::uint32_t to, Flow capacity) {
    for (auto const &[tail, head, room] : {Edge{from, to, capacity}, Edge{to, from, 0}}) {
      next_.push_back(first_[tail]);
      first_[tail] = static_cast<std::uint32_t>(edges_.size());
      edges_.push_back({tail, head, room});
    }
  }

  // Nodes that the source still reaches in the residual graph (the min-cut's source side).
  std::vector<char> source_side(std::uint32_t source, std::uint32_t sink) {
    while (find_distances(source), distance_[sink] != none) {
      at_ = first_;
      while (augment(source, sink)) {
      }
    }
    std::vector<char> side(first_.size());
    for (std::size_t node = 0; node < side.size(); ++node) side[node] = distance_[node] != none;
    return side;
  }

private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  struct Edge {
    std::uint32_t from, to;
    Flow room;
  };

  void find_distances(std::uint32_t source) {
    distance_.assign(first_.size(), none);
    distance_[source] = 0;
    std::vector<std::uint32_t> open = {source};
    for (std::size_t i = 0; i < open.size(); ++i)
      for (std::uint32_t edge = first_[open[i]]; edge != none; edge = next_[edge])
        if (std::uint32_t const to = edges_[edge].to; edges_[edge].room > 0 && distance_[to] == none) {
          distance_[to] = distance_[open[i]] + 1;
          open.push_back(to);
        }
  }

  // Pushes flow along one shortest path; false if no augmenting path of this length is left.
  bool augment(std::uint32_t source, std::uint32_t sink) {
    std::vector<std::uint32_t> path;
    for (std::uint32_t node = source; node != sink;) {
      std::uint32_t &edge = at_[node];
      while (edge != none && !(edges_[edge].room > 0 && distance_[edges_[edge].to] == distance_[node] + 1))
        edge = next_[edge];
      if (edge != none) {
        path.push_back(edge);
        node = edges_[edge].to;
      } else if (path.empty()) {
        return false;
      } else { // a dead end
        node = edges_[path.back()].from;
        at_[node] = next_[path.back()];
        path.pop_back();
      }
    }
    Flow flow = unlimited;
    for (std::uint32_t edge : path) flow = std::min(flow, edges_[edge].room);
    for (std::uint32_t edge : path) {
      edges_[edge].room -= flow;
      edges_[edge ^ 1].room += flow;
    }
    return true;
  }

  std::vector<Edge> edges_; // each followed by its reverse
  std::vector<std::uint32_t> next_, first_, at_, distance_;
};

} // namespace

Closure::Item Closure::add(double profit) {
  profits_.push_back(profit);
  return static_cast<Item>(profits_.size() - 1);
}

void Closure::require(Item item, Item needed) { needs_.push_back({item, needed}); }

std::vector<char> Closure::best() const {
  constexpr double parts = 1024; // of one unit of profit
  auto const count = static_cast<std::uint32_t>(profits_.size()), source = count, sink = count + 1;
  FlowNetwork network(count + std::size_t{2});
  for (std::uint32_t item = 0; item < count; ++item) {
    Flow const profit = std::llround(profits_[item] * parts);
    if (profit > 0) network.add(source, item, profit);
    if (profit < 0) network.add(item, sink, -profit);
  }
  for (Need const &need : needs_) network.add(need.item, need.needed, unlimited);
  std::vector<char> side = network.source_side(source, sink);
  side.resize(count);
  return side;
}

} // namespace symreal
