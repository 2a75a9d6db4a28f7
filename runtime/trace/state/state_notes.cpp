// Entry points of the macros in a rewritten program, which forward to the State of the thread.
#include "runtime/memory/object_end.h"
#include "runtime/memory/own_memory.h"
#include "runtime/trace/state/state.h"

#include <symreal/environment.h>

namespace symreal {

namespace detail {

using trace::Pause;
using trace::State;

void note_static(void const *object, std::size_t size, Scope scope, char const *name, char const *place) noexcept {
  Pause const pause;
  State::current().named(object, size, scope, name, place);
}

void note_local(void const *object, std::size_t size, Scope scope, char const *name, char const *place) noexcept {
  Pause const pause;
  State::current().local(object, size, scope, name, place);
}

bool is_around(void const *address) noexcept { return State::current().is_around(address); }

void note_read(RealNumber const *number, char const *name, char const *place) noexcept {
  Pause const pause;
  State::current().read(number, name, place);
}

void note_written(void const *begin, std::size_t size, char const *name, char const *place) noexcept {
  Pause const pause;
  State::current().written(begin, size, name, place);
}

void note_scalar_read(ScalarObject scalar, char const *name, char const *place) noexcept {
  Pause const pause;
  State::current().read(scalar, name, place);
}

void note_pointer_read(void const *pointer, Behind what, char const *name, char const *place) noexcept {
  Pause const pause;
  State::current().read_pointer(pointer, what, name, place);
}

void note_chosen(void const *begin, std::size_t size) noexcept {
  Pause const pause;
  State::current().chosen(begin, size);
}

void note_scalar_written(ScalarObject scalar, char const *name, char const *place) noexcept {
  Pause const pause;
  State::current().written(scalar, name, place);
}

void given_from_outside(char const *function, double value) noexcept {
  Pause const pause;
  State::current().outside(function, {value});
}

void note_changed(void const *object, Visit visit, char const *name, char const *place) noexcept {
  Pause const pause;
  State::current().changed(object, visit, name, place);
}

bool note_counted(void const *object, Visit visit) noexcept {
  Pause const pause;
  return State::current().counted(object, visit);
}

void check_bits(void const *begin, std::size_t size, char const *name, char const *place) noexcept {
  Pause const pause;
  State::current().check_bits({begin, 0, 8 * size}, name, place);
}

void check_part(void const *begin, std::size_t first, std::size_t count, char const *name, char const *place) noexcept {
  Pause const pause;
  State::current().check_bits({begin, first, count}, name, place);
}

void check_view(void const *begin, char const *name, char const *place) noexcept {
  Pause const pause;
  // The view ends at the kernel's own part of the stack: its callers' objects beyond it are not checked.
  auto const first = reinterpret_cast<std::uintptr_t>(begin);
  std::uintptr_t const end =
      on_own_stack(begin) ? own_stack + own_stack_size : reinterpret_cast<std::uintptr_t>(memory::object_end(begin));
  State::current().check_bits({begin, 0, 8 * (end - first)}, name, place);
}

void const *other_range_end(void const *end, bool is_last, char const *place) noexcept {
  Pause const pause;
  return State::current().other_range_end(end, is_last, place);
}

void scratch(void const *object, std::size_t size, Visit visit) noexcept {
  if (!recording) return;
  Pause const pause;
  State::current().scratch(object, size, visit);
}

void scratch_file(char const *file) noexcept {
  if (!recording) return;
  Pause const pause;
  State::current().scratch_file(file);
}

void constant_bytes(void const *object, std::size_t size) noexcept {
  if (!recording) return;
  Pause const pause;
  State::current().constant(object, size);
}

} // namespace detail
} // namespace symreal
