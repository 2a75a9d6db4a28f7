#include "engine/plan/reroll/chains.h"

#include <functional>
#include <utility>

namespace symreal::reroll {

namespace {

constexpr std::uint32_t window = 12;

// Nodes with several uses far from their definition.
std::vector<char> shared_nodes(Sequence const &sequence) {
  constexpr std::uint32_t far = 200;
  std::vector<char> result(sequence.position.size(), 0);
  std::vector<std::uint32_t> distant(sequence.position.size(), 0);
  for (std::uint32_t at = 0; at < sequence.size(); ++at)
    for (unsigned i = 0; i < sequence.operations[at].count; ++i) {
      NodeId const node = sequence.operations[at].operands[i].node;
      std::uint32_t const made = sequence.position[node];
      if (made != no_position && at - made > far && ++distant[node] >= least_count) result[node] = 1;
    }
  return result;
}

// Seeds: short windows of a sequence that recur with the same operands. Positions of each seed, the most frequent seed
// first. Occurrences of one seed do not overlap, and at least one operand of a seed is not constant.
std::vector<std::vector<std::uint32_t>> seeds(Sequence const &sequence) {
  constexpr std::uint64_t base = 0x9E3779B97F4A7C15;
  std::uint32_t const size = static_cast<std::uint32_t>(sequence.size());
  std::vector<char> const is_shared = shared_nodes(sequence);
  std::vector<std::uint64_t> tokens(size);
  std::vector<std::uint32_t> named(size + std::size_t{1}, 0); // prefix sums: operations with an identifying operand
  for (std::uint32_t at = 0; at < size; ++at) {
    Operation const &operation = sequence.operations[at];
    std::uint64_t token = static_cast<std::uint64_t>(operation.op) + 1;
    bool is_named = false;
    std::array<std::uint64_t, 3> words = {};
    for (unsigned i = 0; i < operation.count; ++i) {
      NodeId const node = operation.operands[i].node;
      Array const source = sequence.array(node);
      bool const has_name = source != Array::memory || is_shared[node];
      words[i] = has_name ? node + std::uint64_t{2} : 1;
      is_named = is_named || (has_name && source != Array::values);
    }
    if (operation.may_exchange && words[1] < words[0]) std::swap(words[0], words[1]);
    for (std::uint64_t const word : words) token = token * base + word;
    tokens[at] = token;
    named[at + 1] = named[at] + (is_named ? 1 : 0);
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> hashes;
  std::vector<std::uint64_t> const all = window_hashes(tokens, window);
  for (std::uint32_t at = 0; at < all.size(); ++at)
    if (named[at] != named[at + window]) hashes.emplace_back(all[at], at);
  std::ranges::sort(hashes);
  std::vector<std::vector<std::uint32_t>> groups;
  for (std::size_t k = 0; k < hashes.size();) {
    std::vector<std::uint32_t> places;
    std::size_t const first = k;
    for (; k < hashes.size() && hashes[k].first == hashes[first].first; ++k)
      if (places.empty() || hashes[k].second >= places.back() + window) places.push_back(hashes[k].second);
    if (places.size() >= least_count) groups.push_back(std::move(places));
  }
  std::ranges::sort(groups, [](auto const &a, auto const &b) {
    return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
  });
  return groups;
}

using Run = std::pair<std::size_t, std::size_t>; // half-open: elements from..to-1

// The longest run whose neighbours are in order.
template <typename Order> Run longest_run(std::vector<std::uint32_t> const &values, Order in_order) {
  Run best = {0, 0};
  for (std::size_t first = 0, k = 0; k < values.size(); ++k) {
    if (k != first && !in_order(values[k - 1], values[k])) first = k;
    if (k + 1 - first > best.second - best.first) best = {first, k + 1};
  }
  return best;
}

// Chains of a run of neighbours.
Chains part(Chains const &chains, Run const &run) {
  auto const at = [](auto const &list, std::size_t k) { return list.begin() + static_cast<std::ptrdiff_t>(k); };
  return {{at(chains.ends, run.first), at(chains.ends, run.second + 1)},
          {at(chains.common, run.first), at(chains.common, run.second)}};
}

// Whether two operations match, where any computed operand fits any other. Signs are left to columns.h.
bool alike(Sequence const &sequence, std::uint32_t at, std::uint32_t other) {
  auto const fit = [&](NodeId x, NodeId y) { return x == y || (sequence.is_computed(x) && sequence.is_computed(y)); };
  return match(sequence.operations[at], sequence.operations[other], fit) != Match::none;
}

// Number of operations at the ends of two chains, at most `common`, that match except for operands from before the
// chain.
std::uint32_t linked(Sequence const &sequence, std::uint32_t end, std::uint32_t other_end, std::uint32_t common) {
  auto const depth = [&](NodeId node, std::uint32_t of) {
    std::uint32_t const at = sequence.position[node];
    return at != no_position && at < of && at >= of - common ? of - at : 0;
  };
  auto const fit = [&](NodeId x, NodeId y) { return x == y || depth(x, end) == depth(y, other_end); };
  for (std::uint32_t d = 1; d <= common; ++d) {
    Operation const &a = sequence.operations[end - d], &b = sequence.operations[other_end - d];
    while (match(a, b, fit) == Match::none) {
      std::uint32_t deepest = 0;
      for (unsigned i = 0; i < a.count; ++i)
        deepest = std::max({deepest, depth(a.operands[i].node, end), depth(b.operands[i].node, other_end)});
      common = deepest - 1;
    }
  }
  return common;
}

class ChainSearch {
public:
  explicit ChainSearch(Sequence const &sequence) : sequence_(sequence), taken_(sequence.size(), 0) {}

  // Chains that may be interchanged, in order of their ends.
  std::vector<Chains> run() {
    constexpr std::size_t most_attempts = 32;
    std::size_t attempts = 0;
    for (std::vector<std::uint32_t> const &places : seeds(sequence_)) {
      if (std::ranges::any_of(places, [&](std::uint32_t at) { return taken_[at] != 0; })) continue;
      if (++attempts > most_attempts) break;
      Chains chains = grown(places);
      if (!may_interchange(chains)) continue;
      for (std::size_t j = 0; j < chains.size(); ++j)
        std::fill(taken_.begin() + chains.begin(j), taken_.begin() + chains.ends[j], 1);
      found_.push_back(std::move(chains));
    }
    std::ranges::sort(found_, {}, [](Chains const &chains) { return chains.ends.back(); });
    return std::move(found_);
  }

private:
  // Extends the chains forward to where most neighbours end, and back to where they differ.
  Chains grown(std::vector<std::uint32_t> const &places) const {
    std::vector<std::uint32_t> lengths;
    for (std::size_t j = 0; j + 1 < places.size(); ++j) {
      std::uint32_t const a = places[j], b = places[j + 1];
      std::uint32_t length = 0;
      while (a + length < b && b + length < sequence_.size() && alike(sequence_, a + length, b + length)) ++length;
      lengths.push_back(length);
    }
    std::vector<std::uint32_t> sorted = lengths; // tolerates a few irregular neighbours
    std::ranges::sort(sorted);
    std::uint32_t length = sorted[sorted.size() / 8];
    std::vector<std::uint32_t> reached;
    for (std::uint32_t const other : lengths) reached.push_back(other >= length ? 1 : 0);
    auto const [first, last] = longest_run(reached, [](std::uint32_t a, std::uint32_t b) { return a == 1 && b == 1; });
    while (length > 0 && !follows(places[first], places[first] + length - 1)) --length;
    Chains chains;
    for (std::size_t j = first; j <= last; ++j) chains.ends.push_back(places[j] + length);
    for (std::size_t j = 0; j + 1 < chains.size(); ++j) {
      std::uint32_t const a = chains.ends[j], b = chains.ends[j + 1],
                          most = std::min(a - (j == 0 ? 0 : chains.ends[j - 1]), b - a);
      std::uint32_t common = 0;
      while (common < most && alike(sequence_, a - common - 1, b - common - 1)) ++common;
      chains.common.push_back(linked(sequence_, a, b, common));
    }
    auto const growing = longest_run(chains.common, std::less()), falling = longest_run(chains.common, std::greater());
    return part(chains, growing.second - growing.first < falling.second - falling.first ? falling : growing);
  }

  // Whether an operation reads a value computed from `begin` on.
  bool follows(std::uint32_t begin, std::uint32_t at) const {
    Operation const &operation = sequence_.operations[at];
    return std::any_of(operation.operands.begin(), operation.operands.begin() + operation.count, [&](Operand const &x) {
      return sequence_.is_computed(x.node) && sequence_.position[x.node] >= begin;
    });
  }

  // Whether no chain depends on another, the operations between them depend on no chain, and lengths vary.
  bool may_interchange(Chains const &chains) const {
    std::vector<std::uint32_t> lengths = chains.common;
    std::ranges::sort(lengths);
    if (lengths.empty() || lengths.front() == lengths.back()) return false;
    std::uint32_t const begin = chains.begin(0), end = chains.ends.back();
    constexpr std::uint32_t none = ~std::uint32_t{0};
    std::vector<std::uint32_t> chain_of(end - begin, none);
    for (std::size_t j = 0; j < chains.size(); ++j)
      for (std::uint32_t at = chains.begin(j); at < chains.ends[j]; ++at) {
        if (taken_[at]) return false;
        chain_of[at - begin] = static_cast<std::uint32_t>(j);
      }
    for (std::uint32_t at = begin; at < end; ++at)
      for (unsigned i = 0; i < sequence_.operations[at].count; ++i) {
        std::uint32_t const made = sequence_.position[sequence_.operations[at].operands[i].node];
        if (made == no_position || made < begin) continue;
        std::uint32_t const chain = chain_of[made - begin];
        if (chain != none && chain != chain_of[at - begin]) return false;
      }
    return true;
  }

  Sequence const &sequence_;
  std::vector<char> taken_; // per operation: whether it belongs to a chain
  std::vector<Chains> found_;
};

} // namespace

std::vector<Chains> find_chains(Sequence const &sequence) { return ChainSearch(sequence).run(); }

} // namespace symreal::reroll
