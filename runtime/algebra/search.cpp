#include "algebra/search.h"

#include "algebra/factoring.h"
#include "algebra/resubstitution.h"

namespace symreal::algebra {

namespace {

// No single setting wins; their alternation does.
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
  return factored(network, random_settings(search.random), search.random, search.work);
}

Network resubstituted_at_random(Network const &network, Search &search) {
  return resubstituted(network, {.largest_first = search.random() % 2 != 0}, search);
}

} // namespace

Network improved(Network network, int steps, Search &search) {
  std::size_t cost = cost_of(network);
  for (int step = 0; step < steps; ++step) {
    search.work += network.size();
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

} // namespace symreal::algebra
