// Hash table from 64-bit keys of nearly uniform distribution to numbers.
#pragma once

#include "engine/optimise/algebra/value.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace symreal::algebra {

class KeyTable {
public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  explicit KeyTable(std::size_t expected = 32) {
    std::size_t size = 64;
    while (size < 2 * expected) size *= 2;
    entries_.assign(size, {0, none});
  }

  std::uint32_t find(std::uint64_t key) const { return entries_[place_of(key)].number; }
  // The number of a key, `none` for a new one. The next call invalidates the reference.
  std::uint32_t &operator[](std::uint64_t key) {
    if (2 * (used_ + 1) > entries_.size()) grow();
    Entry &entry = entries_[place_of(key)];
    if (entry.number == none) {
      entry.key = key;
      ++used_;
    }
    return entry.number;
  }

private:
  struct Entry {
    std::uint64_t key;
    std::uint32_t number;
  };

  std::size_t place_of(std::uint64_t key) const {
    std::size_t const mask = entries_.size() - 1;
    std::size_t place = mixed(key) & mask;
    while (entries_[place].number != none && entries_[place].key != key) place = (place + 1) & mask;
    return place;
  }
  void grow() {
    std::vector<Entry> old(2 * entries_.size(), Entry{0, none});
    old.swap(entries_);
    for (Entry const &entry : old)
      if (entry.number != none) entries_[place_of(entry.key)] = entry;
  }

  std::vector<Entry> entries_;
  std::size_t used_ = 0;
};

} // namespace symreal::algebra
