#include "engine/optimise/algebra/search.h"

#include "engine/support/progress.h"

namespace symreal::algebra {

namespace {

// Each step recomputes a function's value.
constexpr std::size_t work_of_function = 10;

// Random settings, since alternating between settings beats any single one.
Network factored_at_random(Network const &network, SearchState &search) {
  struct Sizes {
    int product, sum;
  };
  static constexpr Sizes sizes[] = {{0, 3}, {5, 3}, {2, 3}, {3, 6}, {1, 8}, {1, 2},
                                    {2, 8}, {0, 2}, {1, 1}, {2, 4}, {0, 6}, {3, 3}};
  static constexpr int uses[] = {8, 4, 2, 3};
  Sizes const size = sizes[search.random() % std::size(sizes)];
  FactoringSettings settings;
  settings.expansion = {.product_size = size.product, .sum_size = size.sum, .most_uses = uses[search.random() % 4]};
  settings.noise = search.random() % 2 ? 0.15 : 0;
  settings.sums_first = search.random() % 2 != 0;
  return factored(network, settings, search);
}

// Takes `steps` steps on the whole network.
Network improved(Network network, int steps, SearchState &search) {
  std::size_t cost = cost_of(network);
  for (int step = 0; step < steps && !search.is_over(); ++step) {
    search.work += network.size() + work_of_function * network.function_count();
    bool const by_resubstitution = search.random() % 6 == 0;
    Network next = by_resubstitution ? resubstituted(network, search.random() % 2 != 0, search)
                                     : factored_at_random(network, search);
    std::size_t const next_cost = cost_of(next);
    if (next_cost > cost) continue;
    network = std::move(next);
    cost = next_cost;
  }
  return network;
}

// Random topological order, depth first from the roots or by levels; neighbours in it are close in the network.
class RandomOrder {
public:
  RandomOrder(Network const &network, SearchState &search) : network_(network), state_(network.size(), 0) {
    std::vector<Literal> roots = network.roots;
    std::uint64_t const way = search.random() % 3;
    if (way == 1) std::ranges::reverse(roots);
    if (way == 2) search.shuffle(roots);
    bool const last_first = search.random() % 2 != 0;
    for (Literal root : roots) visit(root.node(), last_first);
    if (search.random() % 2) sort_by_level();
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

// One pass over the windows of a network.
class Stitching {
public:
  Stitching(Network const &network, WindowSettings const &settings, SearchState &search)
      : network_(network),
        settings_(settings),
        search_(search),
        now_(network.size()),
        window_of_(network.size(), 0),
        result_(network.context()) {}

  Network run() {
    cut(RandomOrder(network_, search_).order);
    mark_crossing();
    for (std::vector<Index> const &window : windows_) improve(window);
    for (Literal root : network_.roots) result_.roots.push_back(now_(root));
    return rebuilt(result_);
  }

private:
  // Cuts the order into windows. Free nodes and leaves stay outside and precede all windows. An interval of a
  // topological order is convex: no path leaves and re-enters it.
  void cut(std::vector<Index> const &order) {
    std::size_t space = 1 + search_.random() % settings_.length;
    windows_.emplace_back();
    for (Index node : order) {
      if (network_[node].is_free() || network_[node].kind == Kind::leaf) {
        now_[node] = result_.copy(network_, network_[node], now_);
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
    LiteralMap placed(part.size());
    for (Index node = 0; node < part.size(); ++node) {
      if (!live[node]) continue;
      bool const is_leaf = part[node].kind == Kind::leaf;
      placed[node] = is_leaf ? now_[outside[part[node].a.bits]] : result_.copy(part, part[node], placed);
    }
    for (std::size_t i = 0; i < crossing.size(); ++i) now_[crossing[i]] = placed(part.roots[i]);
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
  SearchState &search_;
  LiteralMap now_;
  std::vector<std::uint32_t> window_of_;
  std::vector<char> crosses_;
  std::vector<std::vector<Index>> windows_;
  std::unordered_map<Index, Literal> inside_, leaves_;
  Network result_;
};

// Budget of work rather than time, which keeps results deterministic. A million units take about an eighth of a second.
// Proportional to the operations that could be saved, apart from a fixed start.
struct Budget {
  int starts;          // independent searches; the best continues
  std::uint64_t first; // total work of the starts
  std::uint64_t all;
  int disturbances; // failed disturbances before the search ends
};

// Work limit of steps on the whole network, and of a last pass over windows begun within a budget: more than twice the
// work on usual graphs.
std::uint64_t most_of_a_step(std::uint64_t cost) { return 100'000 + 3000 * cost; }

Budget budget_for(int effort, std::uint64_t cost) {
  constexpr std::uint64_t million = 1'000'000;
  if (effort == 1) return {1, million / 10 + 600 * cost, 0, 0};
  std::uint64_t const work =
      std::min(300'000 * cost, std::clamp(120 * million + 45'000 * cost, 300 * cost, 450 * million));
  int const starts = static_cast<int>(std::clamp<std::uint64_t>(12'000 / (cost + 1), 1, 8));
  if (effort == 2) return {starts, work / 2, work, 30};
  return {8, 4 * work, 10 * work, 300};
}

constexpr std::uint64_t largest_as_a_whole = 20'000;

// A network with its cost.
struct CostedNetwork {
  Network network;
  std::size_t cost;
};

// Improves windows until `end` units of work; disturbs the network after some passes without a gain.
CostedNetwork search_in_windows(Network start, SearchState &search, std::uint64_t end, int disturbances,
                                Progress &progress) {
  std::uint64_t counted = search.work;
  constexpr std::size_t lengths[] = {150, 300, 600, 1000};
  constexpr int patience = 5;
  std::size_t cost = cost_of(start);
  search.end = end + most_of_a_step(cost);
  CostedNetwork best = {start, cost};
  Network network = std::move(start);
  for (int idle = 0, disturbed_in_vain = 0; search.work < end;) {
    progress.add(search.work - counted);
    counted = search.work;
    Network next = improved_in_windows(network, {.length = lengths[search.random() % 4]}, search);
    std::size_t const next_cost = cost_of(next);
    idle = next_cost < cost ? 0 : idle + 1;
    if (next_cost <= cost) network = std::move(next), cost = next_cost;
    if (cost < best.cost) {
      best = {network, cost};
      disturbed_in_vain = 0;
    }
    if (idle < patience) continue;
    if (disturbed_in_vain++ == disturbances) break;
    network = rebuilt(factored_at_random(best.network, search)); // escapes a local minimum
    cost = cost_of(network);
    idle = 0;
  }
  return best;
}

} // namespace

Network improved_in_windows(Network const &network, WindowSettings const &settings, SearchState &search) {
  search.work += 1000 + network.size();
  return Stitching(network, settings, search).run();
}

Searched searched(Network const &network, int effort) {
  std::size_t const cost = cost_of(network);
  if (cost == 0) return {network, 0};
  Budget const budget = budget_for(effort, cost);
  CostedNetwork best = {network, cost};
  std::uint64_t work = 0;
  Progress progress("units of the search", budget.all);
  for (int start = 0; start < budget.starts; ++start) {
    SearchState search(static_cast<std::uint64_t>(start) + 1);
    search.end = most_of_a_step(cost);
    Network whole = cost > largest_as_a_whole ? network : improved(network, 12, search);
    CostedNetwork found = search_in_windows(std::move(whole), search, budget.first / budget.starts, 0, progress);
    work += search.work;
    if (found.cost < best.cost) best = std::move(found);
  }
  SearchState search(0);
  search.work = work;
  CostedNetwork found = search_in_windows(std::move(best.network), search, budget.all, budget.disturbances, progress);
  return {std::move(found.network), search.work};
}

} // namespace symreal::algebra
