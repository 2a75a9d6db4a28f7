#include "engine/optimise/algebra/search.h"

#include "engine/optimise/algebra/factoring.h"
#include "engine/optimise/algebra/resubstitution.h"
#include "engine/optimise/algebra/windows.h"
#include "engine/support/progress.h"

#include <algorithm>
#include <utility>

namespace symreal::algebra {

namespace {

// Each step recomputes a function's value.
constexpr std::size_t work_of_function = 10;

// Random settings, since alternating between settings beats any single one.
FactoringSettings random_settings(std::mt19937_64 &random) {
  struct Sizes {
    int product, sum;
  };
  static constexpr Sizes sizes[] = {{0, 3}, {5, 3}, {2, 3}, {3, 6}, {1, 8}, {1, 2},
                                    {2, 8}, {0, 2}, {1, 1}, {2, 4}, {0, 6}, {3, 3}};
  static constexpr int uses[] = {8, 4, 2, 3};
  Sizes const size = sizes[random() % std::size(sizes)];
  FactoringSettings settings;
  settings.expansion = {.product_size = size.product, .sum_size = size.sum, .most_uses = uses[random() % 4]};
  settings.noise = random() % 2 ? 0.15 : 0;
  settings.sums_first = random() % 2 != 0;
  return settings;
}

Network factored_at_random(Network const &network, Search &search) {
  return factored(network, random_settings(search.random), search);
}

Network resubstituted_at_random(Network const &network, Search &search) {
  return resubstituted(network, {.largest_first = search.random() % 2 != 0}, search);
}

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

struct Found {
  Network network;
  std::size_t cost;
};

// Improves windows until `end` units of work; disturbs the network after some passes without a gain.
Found search_in_windows(Network start, Search &search, std::uint64_t end, int disturbances, Progress &progress) {
  std::uint64_t counted = search.work;
  constexpr std::size_t lengths[] = {150, 300, 600, 1000};
  constexpr int patience = 5;
  std::size_t cost = cost_of(start);
  search.end = end + most_of_a_step(cost);
  Found best = {start, cost};
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
    network = disturbed(best.network, search);
    cost = cost_of(network);
    idle = 0;
  }
  return best;
}

} // namespace

Network improved(Network network, int steps, Search &search) {
  std::size_t cost = cost_of(network);
  for (int step = 0; step < steps && !search.is_over(); ++step) {
    search.work += network.size() + work_of_function * network.function_count();
    bool const by_resubstitution = search.random() % 6 == 0;
    Network next = by_resubstitution ? resubstituted_at_random(network, search) : factored_at_random(network, search);
    std::size_t const next_cost = cost_of(next);
    if (next_cost > cost) continue;
    network = std::move(next);
    cost = next_cost;
  }
  return network;
}

Network disturbed(Network const &network, Search &search) { return rebuilt(factored_at_random(network, search)); }

Searched searched(Network const &network, int effort) {
  std::size_t const cost = cost_of(network);
  if (cost == 0) return {network, 0};
  Budget const budget = budget_for(effort, cost);
  Found best = {network, cost};
  std::uint64_t work = 0;
  Progress progress("units of the search", budget.all);
  for (int start = 0; start < budget.starts; ++start) {
    Search search(static_cast<std::uint64_t>(start) + 1);
    search.end = most_of_a_step(cost);
    Network whole = cost > largest_as_a_whole ? network : improved(network, 12, search);
    Found found = search_in_windows(std::move(whole), search, budget.first / budget.starts, 0, progress);
    work += search.work;
    if (found.cost < best.cost) best = std::move(found);
  }
  Search search(0);
  search.work = work;
  Found found = search_in_windows(std::move(best.network), search, budget.all, budget.disturbances, progress);
  return {std::move(found.network), search.work};
}

} // namespace symreal::algebra
