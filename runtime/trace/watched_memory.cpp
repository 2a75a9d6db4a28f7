// Hooks for the memory accesses of the original's instructions, inserted by the pass of oracle/. They are judged like a
// rewritten text's notes (symreal/state.h) if the driver wants code from this recording, not a comparison.
#include "runtime/trace/watched_memory.h"

#include "runtime/trace/nodes/pool.h"

#include <symreal/state.h>

#include <cstdlib>
#include <cstring>

namespace symreal::trace {

namespace {

bool is_watched(void const *begin) { return detail::recording && watches_memory() && !detail::is_own(begin); }

bool holds_node(void const *begin) {
  std::uint64_t bits;
  std::memcpy(&bits, begin, sizeof bits);
  return Pool::is_tagged(bits);
}

} // namespace

bool watches_memory() {
  static bool const is_wanted = std::getenv("SYMREAL_WATCH") != nullptr;
  return is_wanted;
}

} // namespace symreal::trace

using symreal::RealNumber;

extern "C" {

void symreal_reads(void const *begin, std::size_t size, int is_number, char const *name, char const *place) noexcept {
  if (!symreal::trace::is_watched(begin)) return;
  bool const moves_number = size == sizeof(RealNumber) && symreal::trace::holds_node(begin);
  if (is_number || moves_number)
    for (std::size_t at = 0; at + sizeof(RealNumber) <= size; at += sizeof(RealNumber))
      symreal::detail::note_read(reinterpret_cast<RealNumber const *>(static_cast<char const *>(begin) + at), name,
                                 place);
  else if (size <= sizeof(std::uint64_t))
    symreal::detail::note_scalar_read({begin, static_cast<unsigned char>(size), symreal::ScalarObject::Kind::natural},
                                      name, place);
}

void symreal_writes(void const *begin, std::size_t size, int is_number, char const *name, char const *place) noexcept {
  if (!symreal::trace::is_watched(begin)) return;
  if (is_number || size > sizeof(std::uint64_t))
    symreal::detail::note_written(begin, size, name, place);
  else
    symreal::detail::note_scalar_written(
        {begin, static_cast<unsigned char>(size), symreal::ScalarObject::Kind::natural}, name, place);
}

// Reads and writes of bytes: whole words count as numbers.
void symreal_reads_bytes(void const *begin, std::size_t size, char const *name, char const *place) noexcept {
  auto const *bytes = static_cast<char const *>(begin);
  bool const are_words = size % sizeof(RealNumber) == 0;
  std::size_t const step = are_words ? sizeof(RealNumber) : 1;
  for (std::size_t at = 0; at < size; at += step) symreal_reads(bytes + at, step, are_words, name, place);
}

void symreal_writes_bytes(void const *begin, std::size_t size, char const *name, char const *place) noexcept {
  if (symreal::trace::is_watched(begin)) symreal::detail::note_written(begin, size, name, place);
}
}
