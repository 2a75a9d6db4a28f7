// The cheapest choice among things that pay and things that these need: a minimum cut (Picard, "Maximal closure of a
// graph and applications to combinatorial problems", 1976).
#pragma once

#include <cstdint>
#include <vector>

namespace symreal {

// Items are chosen or not. Each has a profit, which is a loss where it is negative; who chooses one chooses what it
// needs.
class Closure {
public:
  using Item = std::uint32_t;

  Item add(double profit);
  void require(Item item, Item needed);
  // The choice of the largest profit, of several the one with the fewest items; by Dinic's maximum flow.
  std::vector<char> best() const;

private:
  struct Need {
    Item item, needed;
  };
  std::vector<double> profits_;
  std::vector<Need> needs_;
};

} // namespace symreal
