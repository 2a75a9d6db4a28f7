// Entry points of a program's annotations: of C++ (<symreal/annotate.h>), and of the original (<symreal/original.h>).
//
// Private copies of read-only data: input pointers of function kernels are rebound to them. Other inputs are annotated
// in place, so that pointers keep their identity, and aliases remain.
#include "engine/support/mutation/is_dropped.h"
#include "engine/support/page_allocator.h"
#include "runtime/memory/heap_blocks.h"
#include "runtime/memory/static_objects.h"
#include "runtime/replay/replay_server.h"
#include "runtime/trace/kernel/object_layout.h"
#include "runtime/trace/session.h"
#include "runtime/trace/sinks.h"
#include "runtime/wire/request.h"

#include <symreal/annotate.h>
#include <symreal/original.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>

namespace symreal {

using trace::Annotations;
using trace::session;
using trace::Session;

namespace {

trace::MakeSink sink_of(detail::CompiledAs program) {
  switch (program) {
  case detail::CompiledAs::symbolic: return trace::make_recorder;
  case detail::CompiledAs::replay: return trace::make_replay;
  case detail::CompiledAs::original: return trace::make_original;
  }
  internal_failure("a program has a sink", __FILE__, __LINE__);
}

std::vector<Annotations::Copy> &copies() { return Session::of_this_thread().annotations.copies; }

// Whether the system reports the address as writable; true if unknown.
bool is_writable(void const *address) {
  memory::OwnWork const own;
  std::FILE *file = std::fopen("/proc/self/maps", "r");
  if (!file) return true;
  auto const wanted = reinterpret_cast<std::uintptr_t>(address);
  bool writable = true;
  char line[512];
  while (std::fgets(line, sizeof line, file)) {
    std::uintptr_t begin = 0, end = 0;
    char rights[5] = "";
    if (std::sscanf(line, "%zx-%zx %4s", &begin, &end, rights) != 3 || wanted < begin || wanted >= end) continue;
    writable = rights[1] == 'w';
    break;
  }
  std::fclose(file);
  return writable;
}

// Memory that ends where an inaccessible page begins.
char *guarded_memory(std::size_t size) {
  auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  std::size_t room = (size + page - 1) / page * page;
  void *memory = map_anonymous(room + page, MAP_PRIVATE);
  internal_check(memory != MAP_FAILED);
  mprotect(static_cast<char *>(memory) + room, page, PROT_NONE);
  return static_cast<char *>(memory) + room - size;
}

} // namespace

bool detail::begin_object(CompiledAs program, Kind kind, char const *label, SourcePlace place) noexcept {
  memory::OwnWork const own;
  return session().kernel.begin_object(sink_of(program), kind, label, place);
}

void detail::element(void *number, bool is_temporary) noexcept {
  memory::OwnWork const own;
  session().kernel.sink().element(number, is_temporary);
}

void detail::holder(void const volatile *object, std::size_t size) noexcept {
  memory::OwnWork const own;
  session().kernel.sink().holder(const_cast<void const *>(object), size);
}

void detail::handed_over(void const volatile *object, std::size_t size) noexcept {
  memory::OwnWork const own;
  session().kernel.sink().handed_over(const_cast<void const *>(object), size);
}

void detail::end_object(std::size_t const *extents, std::size_t rank) noexcept {
  memory::OwnWork const own;
  session().kernel.sink().end_object({extents, extents + rank});
}

void detail::constant_counts(Extents const &shape) noexcept {
  for (ScalarObject const *variable = shape.begin_variables(); variable != shape.end_variables(); ++variable)
    constant_bytes(variable->address, variable->size);
}

bool detail::begin_implicit(char const *label, SourcePlace place) noexcept {
  memory::OwnWork const own;
  session().kernel.annotate(label, place);
  return session().kernel.begin_implicit(label, {place.file, place.line, place.column});
}

void detail::end_implicit() noexcept {
  memory::OwnWork const own;
  session().kernel.sink().end_implicit();
}

void detail::check_index(std::ptrdiff_t index, std::ptrdiff_t count, char const *object) noexcept {
  if ((index < 0 || index >= count) && !is_dropped("SYM203")) session().kernel.refuse_element(object, count);
}

bool detail::begin_function(CompiledAs program, char const *name, SourcePlace place, unsigned call) noexcept {
  memory::OwnWork const own;
  return session().kernel.begin_function(sink_of(program), name, place, call);
}

void detail::end_function() noexcept { session().kernel.end_function(); }

void detail::end_region(CompiledAs, char const *file_name, SourcePlace place) noexcept {
  session().kernel.end_region(file_name, place);
}

void symreal_set_range(double low, double high) noexcept {
  memory::OwnWork const own;
  session().kernel.set_range(low, high);
}

void symreal_set_state(char const *state, char const *derivative, SourcePlace place) noexcept {
  memory::OwnWork const own;
  session().kernel.set_state({state, derivative, {place.file, place.line, place.column}});
}

void symreal_differentiate(char const *wish, SourcePlace place) noexcept {
  memory::OwnWork const own;
  session().kernel.differentiate({wish, {place.file, place.line, place.column}});
}

void FunctionKernel::accept_annotations() noexcept { session().kernel.accept_annotations(); }
void FunctionKernel::begin_outputs() noexcept { session().kernel.begin_outputs(); }
void FunctionKernel::make_plain(void *object, std::size_t size) noexcept {
  if (trace::Pool const &pool = session().pool; pool.is_recording()) pool.make_plain(object, size);
}

void *detail::private_copy(void const *pointer, std::size_t low, std::size_t count) noexcept {
  auto *original = static_cast<char const *>(pointer);
  if (!session().kernel.is_entering_function()) return const_cast<char *>(original);
  bool const is_copy = std::any_of(copies().begin(), copies().end(),
                                   [original](Annotations::Copy const &copy) { return copy.begin == original; });
  if (!is_copy && is_writable(original + low)) return const_cast<char *>(original);
  std::size_t size = low + count, kept = 0;
  char const *source = original;
  // A second section of a rebound pointer: elements that the first one annotated move along.
  for (Annotations::Copy const &copy : copies())
    if (copy.begin == original) {
      if (copy.size >= size) return copy.begin;
      kept = copy.size;
      source = copy.original;
    }
  char *begin = guarded_memory(size);
  std::memcpy(begin, original, kept);
  std::memcpy(begin + kept, source + kept, size - kept);
  copies().push_back({begin, size, source});
  return begin;
}

void const *detail::in_private_copy(void const *pointer) noexcept {
  auto const *at = static_cast<char const *>(pointer);
  if (session().kernel.is_entering_function())
    for (Annotations::Copy const &copy : copies())
      if (copy.original <= at && at <= copy.original + copy.size) return copy.begin + (at - copy.original);
  return pointer;
}

namespace trace {
namespace {

// An original whose instructions record themselves (oracle/) is recorded.
MakeSink sink_of_original() {
  static bool const is_recorded = wire::requested(wire::Entry::record) != nullptr;
  return is_recorded ? make_recorder_of_original : make_original;
}

Kind kind_named(std::string_view name) {
  if (name == "input") return Kind::input;
  if (name == "parameter") return Kind::parameter;
  if (name == "constant") return Kind::constant;
  return name == "scratch" ? Kind::scratch : Kind::output;
}

Annotations &annotations() { return Session::of_this_thread().annotations; }

} // namespace
} // namespace trace
} // namespace symreal

using symreal::Kind;
using symreal::SourcePlace;
using symreal::memory::OwnWork;
using symreal::trace::annotations;
using symreal::trace::Kernel;
using symreal::trace::session;

int symreal_original_object(char const *kind, char const *label, char const *file, unsigned line, unsigned column,
                            void const *frame) {
  OwnWork const own;
  SourcePlace const place{file, line, column, frame};
  if (annotations().is_later) {
    session().kernel.annotate(label, place);
    annotations().later.push_back({label, place, {}});
    return 1;
  }
  annotations().kind = symreal::trace::kind_named(kind);
  return session().kernel.begin_object(symreal::trace::sink_of_original(), annotations().kind, label, place);
}

void symreal_original_bytes(void const volatile *begin, std::size_t size, int is_temporary) {
  OwnWork const own;
  auto *bytes = static_cast<char *>(const_cast<void *>(begin));
  if (annotations().is_later) return annotations().later.back().bytes.push_back({bytes, size});
  auto &sink = session().kernel.sink();
  if (annotations().kind == Kind::constant || annotations().kind == Kind::scratch) return sink.bytes(bytes, size);
  for (std::size_t k = 0; k + sizeof(double) <= size; k += sizeof(double)) sink.element(bytes + k, is_temporary != 0);
}

void symreal_original_layout(void const volatile *begin, char const *layout, symreal_original_visit const *containers,
                             int is_temporary) {
  OwnWork const own;
  struct Numbers final : symreal::trace::LayoutVisitor {
    void number(void const volatile *address) override { symreal_original_bytes(address, sizeof(double), temporary); }
    void container(void const volatile *object, std::size_t size) override { symreal_original_holder(object, size); }
    int temporary = 0;
  } numbers;
  numbers.temporary = is_temporary;
  symreal::trace::visit_layout(begin, layout, containers, numbers, nullptr);
}

void symreal_original_statics(char const *names) {
  OwnWork const own;
  if (!session().kernel.is_recording()) return;
  std::string const wanted = " " + symreal::memory::without_tags(names) + " ";
  for (symreal::memory::StaticObject const &one : session().kernel.sink().static_objects()) {
    std::string const name = symreal::memory::name_in_c(one.name);
    if (wanted.find(" " + name + " ") != wanted.npos) session().kernel.sink().bytes(one.begin, one.size);
  }
}

void symreal_original_holder(void const volatile *begin, std::size_t size) {
  OwnWork const own;
  Kernel &kernel = session().kernel;
  if (kernel.is_recording() && !annotations().is_later) kernel.sink().holder(const_cast<void const *>(begin), size);
}

void symreal_original_handed_over(int active, void const volatile *begin, std::size_t size) {
  OwnWork const own;
  if (active) session().kernel.sink().handed_over(const_cast<void const *>(begin), size);
}

void symreal_original_whole(int active, void const volatile *object) {
  OwnWork const own;
  static char const *const others = symreal::wire::requested(symreal::wire::Entry::returned);
  if (active && others)
    symreal::replay::replay_returned(static_cast<char const *>(const_cast<void const *>(object)), others);
}

void symreal_original_own(void const volatile *begin, std::size_t size) {
  OwnWork const own;
  if (Kernel &kernel = session().kernel; kernel.is_recording())
    kernel.sink().own(const_cast<void const *>(begin), size);
}

void symreal_original_chosen(void const volatile *begin, std::size_t size) {
  OwnWork const own;
  if (Kernel &kernel = session().kernel; kernel.is_recording())
    kernel.sink().chosen(const_cast<void const *>(begin), size);
}

void symreal_original_object_end() {
  OwnWork const own;
  if (!annotations().is_later) session().kernel.sink().end_object({});
}

int symreal_original_function(char const *name, char const *file, unsigned line, unsigned column, unsigned call,
                              void const *frame) {
  OwnWork const own;
  return session().kernel.begin_function(symreal::trace::sink_of_original(), name, {file, line, column, frame}, call);
}

int symreal_original_entered(int active) {
  OwnWork const own;
  session().kernel.accept_annotations();
  return active;
}

int symreal_original_leaving(int active) {
  OwnWork const own;
  if (active) session().kernel.begin_outputs();
  return active;
}

void symreal_original_function_end(int active) {
  if (active) session().kernel.end_function();
}

void symreal_original_returned(int active, char const *label, char const *file, unsigned line, unsigned column,
                               void *value, std::size_t size, char const *layout) {
  if (!symreal_original_leaving(active)) return;
  if (!symreal_original_object("output", label, file, line, column, nullptr)) return;
  if (layout) {
    symreal_original_layout(value, layout, nullptr, 1);
    symreal_original_handed_over(1, value, size);
    symreal_original_whole(1, value);
  } else
    symreal_original_bytes(value, size, 1);
  symreal_original_object_end();
  symreal_original_settle(value, size);
}

void symreal_original_settle(void volatile *begin, std::size_t size) {
  OwnWork const own;
  session().pool.make_plain(const_cast<void *>(begin), size);
}

int symreal_original_compute(double const *input, double const *parameters, double *output) {
  OwnWork const own;
  return symreal::replay::replay_compute(input, parameters, output);
}

void symreal_original_check_index(__PTRDIFF_TYPE__ index, __PTRDIFF_TYPE__ count, char const *object) {
  OwnWork const own;
  if (index < 0 || index >= count) session().kernel.refuse_element(object, count);
}

void symreal_original_range(double low, double high) {
  OwnWork const own;
  session().kernel.set_range(low, high);
}

void symreal_original_state(char const *state, char const *derivative, char const *file, unsigned line,
                            unsigned column) {
  OwnWork const own;
  session().kernel.set_state({state, derivative, {file, line, column}});
}

void symreal_original_differentiate(char const *wish, char const *file, unsigned line, unsigned column) {
  OwnWork const own;
  session().kernel.differentiate({wish, {file, line, column}});
}

void symreal_original_generate(char const *name, char const *file, unsigned line, unsigned column) {
  OwnWork const own;
  session().kernel.end_region(name, {file, line, column});
}

void symreal_original_later(int active) {
  annotations().is_later = active != 0;
  if (active) annotations().later.clear();
}

void symreal_original_outputs(int *active) {
  if (symreal_original_leaving(*active))
    for (auto const &one : annotations().later) {
      SourcePlace const &place = one.place;
      if (!symreal_original_object("output", one.label.c_str(), place.file, place.line, place.column, place.frame))
        continue;
      for (auto const &part : one.bytes) symreal_original_bytes(part.begin, part.size, 0);
      symreal_original_object_end();
    }
  symreal_original_function_end(*active);
}
