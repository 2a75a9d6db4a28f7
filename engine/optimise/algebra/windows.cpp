#include "engine/optimise/algebra/windows.h"

#include <algorithm>
#include <utility>

namespace symreal::algebra {

namespace {

// Random topological order, depth first from the roots or by levels; neighbours in it are close in the network.
class RandomOrder {
public:
  RandomOrder(Network const &network, std::mt19937_64 &random) : network_(network), state_(network.size(), 0) {
    std::vector<Literal> roots = network.roots;
    std::uint64_t const way = random() % 3;
    if (way == 1) std::ranges::reverse(roots);
    if (way == 2)
      for (std::size_t i = roots.size(); i > 1; --i) std::swap(roots[i - 1], roots[random() % i]);
    bool const last_first = random() % 2 != 0;
    for (Literal root : roots) visit(root.node(), last_first);
    if (random() % 2) sort_by_level();
  }

  std::vector<Index> order;

private:
  void visit(Index root, bool last_first) {
    open_ = {root};
    while (!open_.empty()) {
      Index const node = open_.back();
      if (state_[node] != 0) {
        open_.pop_back();
        if (std::exchange(state_[node], char{2}) == 1) order.push_back(node);
        continue;
      }
      state_[node] = 1;
      std::size_t const first = open_.size();
      network_.for_each_operand(network_[node], [&](Literal operand) {
        if (state_[operand.node()] == 0) open_.push_back(operand.node());
      });
      if (last_first) std::reverse(open_.begin() + static_cast<std::ptrdiff_t>(first), open_.end());
    }
  }

  void sort_by_level() {
    std::vector<std::uint32_t> level(network_.size(), 0);
    for (Index node : order)
      network_.for_each_operand(
          network_[node], [&](Literal operand) { level[node] = std::max(level[node], level[operand.node()] + 1); });
    std::ranges::stable_sort(order, {}, [&](Index node) { return level[node]; });
  }

  Network const &network_;
  std::vector<char> state_;
  std::vector<Index> open_;
};

class Stitching {
public:
  Stitching(Network const &network, WindowSettings const &settings, Search &search)
      : network_(network),
        settings_(settings),
        search_(search),
        now_(network.size()),
        window_of_(network.size(), 0),
        result_(network.context()) {}

  Network run() {
    cut(RandomOrder(network_, search_.random).order);
    mark_crossing();
    for (std::vector<Index> const &window : windows_) improve(window);
    for (Literal root : network_.roots) result_.roots.push_back(now(root));
    return rebuilt(result_);
  }

private:
  Literal now(Literal old) const { return now_[old.node()].negated_if(old.is_negative()); }

  // Cuts the order into windows. Free nodes stay outside and precede all windows. An interval of a topological order is
  // convex: no path leaves and re-enters it.
  void cut(std::vector<Index> const &order) {
    std::size_t space = 1 + search_.random() % settings_.length;
    windows_.emplace_back();
    for (Index node : order) {
      if (network_[node].is_free()) {
        now_[node] = result_.copy(network_, network_[node], [&](Literal operand) { return now(operand); });
      } else if (network_[node].kind == Kind::leaf) {
        now_[node] = result_.copy(network_, network_[node], [&](Literal operand) { return operand; });
      } else {
        if (space-- == 0) {
          windows_.emplace_back();
          space = settings_.length - 1;
        }
        windows_.back().push_back(node);
        window_of_[node] = static_cast<std::uint32_t>(windows_.size());
      }
    }
  }

  // Marks nodes with uses outside their window.
  void mark_crossing() {
    crosses_.assign(network_.size(), 0);
    for (Literal root : network_.roots) crosses_[root.node()] = 1;
    for (std::vector<Index> const &window : windows_)
      for (Index node : window)
        network_.for_each_operand(network_[node], [&](Literal operand) {
          if (window_of_[operand.node()] != window_of_[node]) crosses_[operand.node()] = 1;
        });
  }

  void improve(std::vector<Index> const &window) {
    // Tags of the leaves of `part` are indices into `outside`.
    std::vector<Index> outside;
    Network part(network_.context());
    for (Index node : window) {
      auto operand = [&](Literal old) {
        Index const from = old.node();
        if (window_of_[from] == window_of_[node]) return inside_.at(from).negated_if(old.is_negative());
        return leaf(part, from, outside).negated_if(old.is_negative());
      };
      inside_.insert_or_assign(node, part.copy(network_, network_[node], operand));
    }
    std::vector<Index> crossing;
    for (Index node : window)
      if (crosses_[node]) {
        crossing.push_back(node);
        part.roots.push_back(inside_.at(node));
      }
    inside_.clear();
    leaves_.clear();
    part = improved(std::move(part), settings_.steps, search_);

    std::vector<char> const live = live_nodes(part);
    std::vector<Literal> placed(part.size());
    auto map = [&](Literal old) { return placed[old.node()].negated_if(old.is_negative()); };
    for (Index node = 0; node < part.size(); ++node) {
      if (!live[node]) continue;
      bool const is_leaf = part[node].kind == Kind::leaf;
      placed[node] = is_leaf ? now_[outside[part[node].a.bits]] : result_.copy(part, part[node], map);
    }
    for (std::size_t i = 0; i < crossing.size(); ++i) now_[crossing[i]] = map(part.roots[i]);
  }

  Literal leaf(Network &part, Index from, std::vector<Index> &outside) {
    NetworkNode const &node = network_[from];
    if (node.kind == Kind::constant) return part.constant(node.value);
    auto const [known, is_new] = leaves_.try_emplace(from);
    if (is_new) {
      known->second = part.leaf(static_cast<std::uint32_t>(outside.size()), node.attribute, node.hazards, node.value);
      outside.push_back(from);
    }
    return known->second;
  }

  Network const &network_;
  WindowSettings const &settings_;
  Search &search_;
  std::vector<Literal> now_;
  std::vector<std::uint32_t> window_of_;
  std::vector<char> crosses_;
  std::vector<std::vector<Index>> windows_;
  std::unordered_map<Index, Literal> inside_, leaves_;
  Network result_;
};

} // namespace

Network improved_in_windows(Network const &network, WindowSettings const &settings, Search &search) {
  search.work += 1000 + network.size();
  return Stitching(network, settings, search).run();
}

} // namespace symreal::algebra
