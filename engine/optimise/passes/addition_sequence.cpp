#include "engine/optimise/passes/addition_sequence.h"

#include <algorithm>

namespace symreal {

namespace {

// Iterative deepening over ascending chains (Knuth, The Art of Computer Programming, volume 2, 4.6.3). A chain that has
// passed a wanted number never reaches it.
class ChainSearch {
public:
  ChainSearch(std::vector<int> const &given, std::vector<int> const &wanted) : wanted_(wanted), chain_(given) {}

  bool run(std::size_t most_additions) {
    for (std::size_t additions = 0; additions <= most_additions && steps_ < most_steps; ++additions)
      if (extend(additions, 0)) return true;
    return false;
  }

  std::vector<Addition> made;

private:
  static constexpr int most_steps = 200'000;

  bool extend(std::size_t left, std::size_t reached) {
    while (reached < wanted_.size() && std::ranges::binary_search(chain_, wanted_[reached])) ++reached;
    if (reached == wanted_.size()) return true;
    if (wanted_.size() - reached > left || ++steps_ > most_steps) return false;
    int const last = chain_.back(), next = wanted_[reached];
    if (static_cast<long>(last) << left < wanted_.back()) return false;
    std::vector<Addition> candidates;
    for (std::size_t i = chain_.size(); i-- > 0;)
      for (std::size_t j = i + 1; j-- > 0;) {
        int const sum = chain_[i] + chain_[j];
        if (sum > last && sum <= next && std::ranges::find(candidates, sum, &Addition::sum) == candidates.end())
          candidates.push_back({sum, chain_[i], chain_[j]});
      }
    std::ranges::stable_sort(candidates, std::ranges::greater{}, &Addition::sum);
    for (Addition const &candidate : candidates) {
      chain_.push_back(candidate.sum);
      made.push_back(candidate);
      if (extend(left - 1, reached)) return true;
      chain_.pop_back();
      made.pop_back();
    }
    return false;
  }

  std::vector<int> const &wanted_;
  std::vector<int> chain_;
  int steps_ = 0;
};

class BinaryMethod {
public:
  explicit BinaryMethod(std::vector<int> const &given) : unit_(given.front()), known_(given) {}

  void reach(int number) {
    if (std::ranges::find(known_, number) != known_.end()) return;
    bool const is_even = number / unit_ % 2 == 0;
    int const a = is_even ? number / 2 : number - unit_;
    reach(a);
    known_.push_back(number);
    made.push_back({number, a, number - a});
  }

  std::vector<Addition> made;

private:
  int unit_;
  std::vector<int> known_;
};

} // namespace

std::vector<Addition> addition_sequence(std::vector<int> given, std::vector<int> wanted) {
  std::ranges::sort(given);
  std::ranges::sort(wanted);
  BinaryMethod binary(given);
  for (int number : wanted) binary.reach(number);
  ChainSearch search(given, wanted);
  return search.run(binary.made.size()) ? search.made : binary.made;
}

} // namespace symreal
