#include "engine/plan/reroll/seeds.h"

#include "engine/plan/reroll/windows.h"

#include <algorithm>

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

} // namespace

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
      Source const source = sequence.source(node);
      bool const has_name = source != Source::computed || is_shared[node];
      words[i] = has_name ? node + std::uint64_t{2} : 1;
      is_named = is_named || (has_name && source != Source::constant);
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

} // namespace symreal::reroll
