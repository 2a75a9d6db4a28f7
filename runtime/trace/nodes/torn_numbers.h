// Torn numbers: symbolic numbers of which the program has overwritten some bits, through a union, a pointer or a byte
// function, with their address, the place of the store, and the bits.
//
// Memory may be reused for another object, an integer in place of a number, and be overwritten piece by piece. So a
// partial store is an error only once the rest of the number is used, as a number or as bits. An object that the source
// names as a number cannot be reused: it is an error at the latest when the kernel ends.
#pragma once

#include "runtime/trace/parts/parts.h"

#include <symreal/real_number.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <set>
#include <string>
#include <unordered_map>

namespace symreal::trace {

class TornNumbers {
public:
  explicit TornNumbers(Pool const &pool) : pool_(pool) {}

  struct Bits {
    void const *begin;
    std::size_t first, count;
  };
  struct Site {
    char const *name, *place; // literals of the program
  };

  void begin();
  // These bits are about to get new values.
  void store(Bits bits, bool is_number, Site const &site);
  // The program reads one or more numbers in these bits.
  void use(Bits bits, Site const &site);
  // Whether any of these bits belong to a symbolic number, whole or torn.
  bool is_symbolic(Bits bits);
  // Place where a number with these bits was overwritten; empty if unknown.
  std::string place_of(RealNumber number) const;
  void end();

private:
  struct Torn {
    std::uint64_t before, stored; // the number, and a mask of the bits that were overwritten
    bool is_number;
    Site site;

    bool is_left_in(std::uint64_t word) const { return ((word ^ before ^ mark) & ~stored) == 0; }
  };
  // Bits to invert in the rest of a torn number: it then equals no number, even if the program stores the old bytes
  // back, and is distinct from a number stored there later.
  static constexpr std::uint64_t mark = 0x0001'5A5A'A5A5'5A5Au;
  using Table = std::unordered_map<std::uint64_t *, Torn>;

  Table::iterator find(std::uint64_t *word);
  Torn const *find_copied(std::uint64_t word) const;
  void drop(Table::iterator torn);
  void report_store(Torn const &torn, std::string const &used);
  void changed();
  bool is_whole(std::uint64_t word) const;

  Pool const &pool_;
  Table torn_;
  std::deque<Torn> gone_;          // the last of those whose memory was reused; copies may be left
  std::set<std::string> reported_; // places
};

} // namespace symreal::trace
