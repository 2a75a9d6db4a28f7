// Entry points of a program's annotations (<symreal/annotate.h>).
#include "engine/support/mutation/is_dropped.h"
#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/sinks.h"

namespace symreal {

using trace::Kernel;

static trace::MakeSink sink_of(detail::CompiledAs program) {
  switch (program) {
  case detail::CompiledAs::symbolic: return trace::make_recorder;
  case detail::CompiledAs::replay: return trace::make_replay;
  case detail::CompiledAs::original: return trace::make_original;
  }
  internal_failure("a program has a sink", __FILE__, __LINE__);
}

bool detail::begin_object(CompiledAs program, Kind kind, char const *label, SourcePlace place) noexcept {
  memory::OwnWork const own;
  return Kernel::current().begin_object(sink_of(program), kind, label, place);
}

void detail::element(void *number, bool is_temporary) noexcept {
  memory::OwnWork const own;
  Kernel::current().sink().element(number, is_temporary);
}

void detail::holder(void const volatile *object, std::size_t size) noexcept {
  memory::OwnWork const own;
  Kernel::current().sink().holder(const_cast<void const *>(object), size);
}

void detail::handed_over(void const volatile *object, std::size_t size) noexcept {
  memory::OwnWork const own;
  Kernel::current().sink().handed_over(const_cast<void const *>(object), size);
}

void detail::end_object(std::size_t const *extents, std::size_t rank) noexcept {
  memory::OwnWork const own;
  Kernel::current().sink().end_object({extents, extents + rank});
}

void detail::constant_counts(Extents const &shape) noexcept {
  for (ScalarObject const *variable = shape.begin_variables(); variable != shape.end_variables(); ++variable)
    constant_bytes(variable->address, variable->size);
}

bool detail::begin_implicit(char const *label, SourcePlace place) noexcept {
  memory::OwnWork const own;
  Kernel::current().annotate(label, place);
  return Kernel::current().begin_implicit(label, {place.file, place.line, place.column});
}

void detail::end_implicit() noexcept {
  memory::OwnWork const own;
  Kernel::current().sink().end_implicit();
}

void detail::check_index(std::ptrdiff_t index, std::ptrdiff_t count, char const *object) noexcept {
  if ((index < 0 || index >= count) && !is_dropped("SYM203")) Kernel::current().refuse_element(object, count);
}

bool detail::begin_function(CompiledAs program, char const *name, SourcePlace place, unsigned call) noexcept {
  memory::OwnWork const own;
  return Kernel::current().begin_function(sink_of(program), name, place, call);
}

void detail::end_function() noexcept { Kernel::current().end_function(); }

void detail::end_region(CompiledAs, char const *file_name, SourcePlace place) noexcept {
  Kernel::current().end_region(file_name, place);
}

void symreal_set_range(double low, double high) noexcept {
  memory::OwnWork const own;
  Kernel::current().set_range(low, high);
}

void symreal_set_state(char const *state, char const *derivative, SourcePlace place) noexcept {
  memory::OwnWork const own;
  Kernel::current().set_state({state, derivative, {place.file, place.line, place.column}});
}

void symreal_differentiate(char const *wish, SourcePlace place) noexcept {
  memory::OwnWork const own;
  Kernel::current().differentiate({wish, {place.file, place.line, place.column}});
}

void FunctionKernel::accept_annotations() noexcept { Kernel::current().accept_annotations(); }
void FunctionKernel::begin_outputs() noexcept { Kernel::current().begin_outputs(); }

} // namespace symreal
