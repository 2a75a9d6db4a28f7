// Symbolic numbers of which the program has overwritten some bits, through a union, a pointer or a function that moves
// bytes: where they lie, where that was, and which bits.
//
// Memory may hold something else from now on, an integer in place of a number, and be overwritten piece by piece. So a
// part that is stored is an error as soon as what is left of the number is used: as a number, or as bits. An object
// that the source names as a number is nothing else: there it is an error at the latest when the kernel ends.
#pragma once

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
  static TornNumbers &current(); // one per thread

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
  // The number is read, or numbers are.
  void use(Bits bits, Site const &site);
  // Are symbolic bits among these, of a whole number or of what is left of one?
  bool is_symbolic(Bits bits);
  // Where a number with these bits was overwritten; empty where that is not known.
  std::string place_of(RealNumber number) const;
  void end();

private:
  struct Torn {
    std::uint64_t before, stored; // the number, and a mask of the bits that were overwritten
    bool is_number;
    Site site;

    bool is_left_in(std::uint64_t word) const { return ((word ^ before ^ mark) & ~stored) == 0; }
  };
  // What is left of a number gets these bits inverted: so it is that of no number, even if the program stores what was
  // there before, and is told from a number that is stored there later.
  static constexpr std::uint64_t mark = 0x0001'5A5A'A5A5'5A5Au;
  using Table = std::unordered_map<std::uint64_t *, Torn>;

  Table::iterator find(std::uint64_t *word);
  Torn const *find_copied(std::uint64_t word) const;
  void drop(Table::iterator torn);
  void report_store(Torn const &torn, std::string const &used);
  void changed();

  Table torn_;
  std::deque<Torn> gone_;          // the last of those whose memory holds something else by now; copies may be left
  std::set<std::string> reported_; // places
};

} // namespace symreal::trace
