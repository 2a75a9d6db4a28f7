#include "runtime/trace/nodes/torn_numbers.h"

#include "engine/support/mutation/is_dropped.h"
#include "runtime/memory/own_memory.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/events.h"

#include <symreal/state.h>

#include <algorithm>
#include <bit>
#include <vector>

namespace symreal {

__thread bool detail::any_torn = false;

namespace trace {

namespace {

constexpr std::uint64_t all_bits = ~std::uint64_t{0};

// The words of memory that the bits belong to, and which of their bits.
template <class Visit> void each_word(TornNumbers::Bits bits, Visit visit) {
  auto const address = reinterpret_cast<std::uintptr_t>(bits.begin);
  std::size_t first = address % 8 * 8 + bits.first;
  auto *word =
      reinterpret_cast<std::uint64_t *>(address - address % 8) + first / 64; // NOLINT(performance-no-int-to-ptr)
  first %= 64;
  for (std::size_t left = bits.count; left != 0; ++word, first = 0) {
    std::size_t const here = std::min(left, 64 - first);
    visit(word, (here == 64 ? all_bits : (std::uint64_t{1} << here) - 1) << first);
    left -= here;
  }
}

} // namespace

bool TornNumbers::is_whole(std::uint64_t word) const { return pool_.owns(RealNumber::from_bits(word)); }

void TornNumbers::begin() {
  memory::OwnWork const own;
  torn_.clear();
  gone_.clear();
  reported_.clear();
  changed();
}

void TornNumbers::changed() { detail::any_torn = !torn_.empty() || !gone_.empty(); }

// A torn number that was copied to this word: enough of its bits are here to exclude chance.
TornNumbers::Torn const *TornNumbers::find_copied(std::uint64_t word) const {
  constexpr int enough = 16;
  auto const is_origin = [word](Torn const &torn) {
    return std::popcount(~torn.stored) >= enough && torn.is_left_in(word);
  };
  for (auto const &[at, torn] : torn_)
    if (is_origin(torn)) return &torn;
  auto const found = std::find_if(gone_.begin(), gone_.end(), is_origin);
  return found == gone_.end() ? nullptr : &*found;
}

void TornNumbers::drop(Table::iterator torn) {
  constexpr std::size_t most = 64;
  gone_.push_back(torn->second);
  if (gone_.size() > most) gone_.pop_front();
  torn_.erase(torn);
}

// The torn number at the word, unless the program has stored something else there since.
TornNumbers::Table::iterator TornNumbers::find(std::uint64_t *word) {
  auto const found = torn_.find(word);
  if (found == torn_.end()) return found;
  Torn const &torn = found->second;
  if (!is_whole(*word) && torn.is_left_in(*word)) return found;
  if (torn.is_number) report_store(torn, "");
  drop(found);
  return torn_.end();
}

void TornNumbers::report_store(Torn const &torn, std::string const &used) {
  if (!reported_.insert(torn.site.place).second) return;
  report({DiagnosticId::reinterpretation, written_place(torn.site.place),
          "a part of the symbolic value behind '" + std::string(torn.site.name) + "' is overwritten" + used});
}

void TornNumbers::store(Bits bits, bool is_number, Site const &site) {
  if (is_dropped("torn")) return;
  each_word(bits, [&](std::uint64_t *word, std::uint64_t mask) {
    if (mask == all_bits && torn_.empty()) return;
    auto found = find(word);
    if (found == torn_.end() && mask != all_bits && !is_whole(*word))
      if (Torn const *copied = find_copied(*word)) {
        Torn torn = *copied;
        torn.is_number = false;
        found = torn_.insert({word, torn}).first;
      }
    if (found != torn_.end()) {
      if ((found->second.stored | mask) == all_bits)
        drop(found);
      else
        found->second.stored |= mask;
    } else if (mask != all_bits && is_whole(*word)) {
      torn_.insert({word, {*word, mask, is_number, site}});
      *word ^= mark;
    }
  });
  changed();
}

void TornNumbers::use(Bits bits, Site const &site) {
  each_word(bits, [&](std::uint64_t *word, std::uint64_t mask) {
    auto const found = find(word);
    Torn const *torn = found != torn_.end() ? &found->second : is_whole(*word) ? nullptr : find_copied(*word);
    if (!torn || (mask & ~torn->stored) == 0) return;
    report_store(*torn, ", and the number is used at " + std::string(site.place));
    *word = torn->before; // so that the program goes on with a value
    if (found != torn_.end()) torn_.erase(found);
  });
  changed();
}

bool TornNumbers::is_symbolic(Bits bits) {
  bool is_any = false;
  each_word(bits, [&](std::uint64_t *word, std::uint64_t mask) {
    auto const found = find(word);
    RealNumber const number = RealNumber::from_bits(*word);
    Torn const *torn = found != torn_.end() ? &found->second : Pool::is_torn(number) ? find_copied(*word) : nullptr;
    // Bits without a node's mark may lie below one that is left from another object.
    bool const has_mark = mask >> detail::node_shape_at != 0 && number.is_node();
    is_any |= torn ? (mask & ~torn->stored) != 0 : has_mark || is_whole(*word);
  });
  return is_any;
}

std::string TornNumbers::place_of(RealNumber number) const {
  Torn const *torn = Pool::is_torn(number) ? find_copied(number.to_bits()) : nullptr;
  return torn ? torn->site.place : "";
}

void TornNumbers::end() {
  memory::OwnWork const own;
  std::vector<std::uint64_t *> numbers;
  for (auto const &[word, torn] : torn_)
    if (torn.is_number) numbers.push_back(word);
  std::sort(numbers.begin(), numbers.end());
  for (std::uint64_t *word : numbers) report_store(torn_.at(word), "");
  begin();
}

} // namespace trace

namespace detail {

using trace::Pause;
using trace::session;

void note_bits_stored(void const *begin, std::size_t first, std::size_t count, Holds holds, char const *name,
                      char const *place) noexcept {
  Pause const pause;
  session().torn_numbers.store({begin, first, count}, holds == Holds::number, {name, place});
}

void note_number_used(void const *begin, std::size_t size, char const *name, char const *place) noexcept {
  Pause const pause;
  session().torn_numbers.use({begin, 0, 8 * size}, {name, place});
}

} // namespace detail
} // namespace symreal
