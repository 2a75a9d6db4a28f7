// Maximum-weight closure of a graph by a minimum cut (Picard, "Maximal closure of a graph and applications to
// combinatorial problems", 1976).
#pragma once

#include <cstdint>
#include <vector>

namespace symreal {

// Items with profits, negative for a loss. Choosing an item requires choosing the items that it needs.
class Closure {
public:
  using Item = std::uint32_t;

  Item add(double profit);
  void require(Item item, Item needed);
  // The choice of the largest profit; the smallest one on ties. Solved by Dinic's maximum flow.
  std::vector<char> best() const;

private:
  struct Need {
    Item item, needed;
  };
  std::vector<double> profits_;
  std::vector<Need> needs_;
};

} // namespace symreal
