// Pseudorandom numbers, the same on every machine.
#pragma once

#include <cstdint>

namespace symreal {

// A bijection of words, each of whose bits depends on all: the output function of SplitMix64.
inline std::uint64_t mix(std::uint64_t z) {
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
  z = (z ^ z >> 27) * 0x94d049bb133111eb;
  return z ^ z >> 31;
}

// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, 2014).
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() { return mix(state_ += 0x9e3779b97f4a7c15); }
  // A number below `end`, which is not 0.
  std::uint64_t below(std::uint64_t end) { return next() % end; }

private:
  std::uint64_t state_;
};

} // namespace symreal
