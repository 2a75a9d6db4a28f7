// Hashes of all windows of a sequence of tokens.
#pragma once

#include <cstdint>
#include <vector>

namespace symreal::reroll {

// Per token, the hash of the `window` tokens from it on, except near the end. Method: Karp-Rabin rolling hash.
inline std::vector<std::uint64_t> window_hashes(std::vector<std::uint64_t> const &tokens, std::size_t window) {
  constexpr std::uint64_t base = 0x9E3779B97F4A7C15, spread = 0xD6E8FEB86659FD93;
  std::uint64_t leaving = 1, hash = 0;
  for (std::size_t k = 0; k + 1 < window; ++k) leaving *= base;
  auto const word = [&](std::size_t k) { return (tokens[k] ^ tokens[k] >> 29) * spread + 1; };
  std::vector<std::uint64_t> hashes;
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    if (k >= window) hash -= word(k - window) * leaving;
    hash = hash * base + word(k);
    if (k + 1 >= window) hashes.push_back(hash);
  }
  return hashes;
}

} // namespace symreal::reroll
