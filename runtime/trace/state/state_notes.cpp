// Entry points that forward to the State of the thread: those of the macros in a rewritten program, and those of the
// original's instructions, inserted by the pass of oracle/.
#include "runtime/memory/own_memory.h"
#include "runtime/memory/static_objects.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/state/state.h"
#include "runtime/wire/request.h"

#include <symreal/environment.h>

#include <cstdlib>
#include <cstring>

namespace symreal {

namespace detail {

using trace::Pause;
using trace::session;

void note_static(void const *object, std::size_t size, Scope scope, char const *name, char const *place) noexcept {
  Pause const pause;
  session().state.named(object, size, scope, name, place);
}

void note_local(void const *object, std::size_t size, Scope scope, char const *name, char const *place) noexcept {
  Pause const pause;
  session().state.local(object, size, scope, name, place);
}

bool is_around(void const *address) noexcept { return session().state.is_around(address); }

void note_read(RealNumber const *number, char const *name, char const *place) noexcept {
  Pause const pause;
  session().state.read(number, name, place);
}

void note_written(void const *begin, std::size_t size, char const *name, char const *place) noexcept {
  Pause const pause;
  session().state.written(begin, size, name, place);
}

void note_scalar_read(ScalarObject scalar, char const *name, char const *place) noexcept {
  Pause const pause;
  session().state.read(scalar, name, place);
}

void note_pointer_read(void const *pointer, Behind what, char const *name, char const *place) noexcept {
  Pause const pause;
  session().state.read_pointer(pointer, what, name, place);
}

void note_chosen(void const *begin, std::size_t size) noexcept {
  Pause const pause;
  session().state.chosen(begin, size);
}

void note_scalar_written(ScalarObject scalar, char const *name, char const *place) noexcept {
  Pause const pause;
  session().state.written(scalar, name, place);
}

void given_from_outside(char const *function, double value) noexcept {
  Pause const pause;
  session().state.outside(function, {value});
}

void note_changed(void const *object, Visit visit, char const *name, char const *place) noexcept {
  Pause const pause;
  session().state.changed(object, visit, name, place);
}

bool note_counted(void const *object, Visit visit) noexcept {
  Pause const pause;
  return session().state.counted(object, visit);
}

void check_bits(void const *begin, std::size_t size, char const *name, char const *place) noexcept {
  Pause const pause;
  session().state.check_bits({begin, 0, 8 * size}, name, place);
}

void check_part(void const *begin, std::size_t first, std::size_t count, char const *name, char const *place) noexcept {
  Pause const pause;
  session().state.check_bits({begin, first, count}, name, place);
}

void check_view(void const *begin, char const *name, char const *place) noexcept {
  Pause const pause;
  // The view ends at the kernel's own part of the stack: its callers' objects beyond it are not checked.
  auto const first = reinterpret_cast<std::uintptr_t>(begin);
  std::uintptr_t const end =
      on_own_stack(begin) ? own_stack + own_stack_size : reinterpret_cast<std::uintptr_t>(memory::object_end(begin));
  session().state.check_bits({begin, 0, 8 * (end - first)}, name, place);
}

void const *other_range_end(void const *end, bool is_last, char const *place) noexcept {
  Pause const pause;
  return session().state.other_range_end(end, is_last, place);
}

void scratch(void const *object, std::size_t size, Visit visit) noexcept {
  if (!recording) return;
  Pause const pause;
  session().state.scratch(object, size, visit);
}

void scratch_file(char const *file) noexcept {
  if (!recording) return;
  Pause const pause;
  session().state.scratch_file(file);
}

void constant_bytes(void const *object, std::size_t size) noexcept {
  if (!recording) return;
  Pause const pause;
  session().state.constant(object, size);
}

} // namespace detail

namespace trace {

bool watches_memory() {
  static bool const is_wanted = wire::requested(wire::Entry::watch) != nullptr;
  return is_wanted;
}

namespace {

bool is_watched(void const *begin) { return detail::recording && watches_memory() && !detail::is_own(begin); }

bool holds_node(void const *begin) {
  std::uint64_t bits;
  std::memcpy(&bits, begin, sizeof bits);
  return Pool::is_tagged(bits);
}

} // namespace
} // namespace trace
} // namespace symreal

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
} // extern "C"
