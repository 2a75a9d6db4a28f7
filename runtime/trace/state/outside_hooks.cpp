// Hooks for values that come from outside of the program while a kernel is recorded, from clocks, files, the
// environment, or a random generator; they are baked in like other hidden state. The hooks replace functions of the C
// library in the whole symbolic program and in the original, together with the heap's, and call the library's.
//
// Weak, so that a program with a function of such a name has its own.
#include "engine/support/mutation/is_dropped.h"
#include "runtime/memory/heap_blocks.h"
#include "runtime/memory/own_memory.h"
#include "runtime/trace/outside/world.h"
#include "runtime/trace/state/state.h"

#ifdef __GLIBC__

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <dlfcn.h>
#include <sys/types.h>
#include <type_traits>

namespace {

template <class Result> void note(char const *name, [[maybe_unused]] Result result, bool is_left_out = false) {
  if (symreal::memory::OwnWork::is_going_on()) return;
  int const kept = errno;
  symreal::trace::note_result(name);
  if (symreal::detail::recording && !is_left_out) {
    symreal::trace::Pause const pause;
    if constexpr (std::is_arithmetic_v<Result>)
      symreal::trace::session().state.outside(name, {static_cast<double>(result)});
    else
      symreal::trace::session().state.outside(name, {});
  }
  errno = kept;
}

} // namespace

// Whether the runtime itself asks: such values are not the program's.
static bool is_of_runtime(char const *name) { return std::strncmp(name, "SYMREAL_", 8) == 0; }
template <class... Arguments> static bool is_of_runtime(Arguments...) { return false; }

extern "C" {

char symreal_outside_hooks = 0;

#define OUTSIDE(result, symbol, name, parameters, arguments)                                                           \
  result symreal_outside_##symbol parameters asm(#symbol);                                                             \
  [[gnu::weak]] result symreal_outside_##symbol parameters {                                                           \
    using Function = result(*) parameters;                                                                             \
    static auto const original = reinterpret_cast<Function>(dlsym(RTLD_NEXT, #symbol));                                \
    result const value = original arguments;                                                                           \
    if (!is_of_runtime arguments) note(name, value, symreal::is_dropped(#symbol));                                     \
    return value;                                                                                                      \
  }
#include "engine/support/outside.def"
#undef OUTSIDE

// Variadic functions, under the names that the headers of the C library give them.
#define SCANNED(symbol)                                                                                                \
  int symreal_outside_##symbol(std::FILE *file, char const *format, ...) asm(#symbol);                                 \
  [[gnu::weak]] int symreal_outside_##symbol(std::FILE *file, char const *format, ...) {                               \
    va_list arguments;                                                                                                 \
    va_start(arguments, format);                                                                                       \
    int const value = std::vfscanf(file, format, arguments);                                                           \
    va_end(arguments);                                                                                                 \
    note("fscanf()", value);                                                                                           \
    return value;                                                                                                      \
  }
SCANNED(fscanf)
SCANNED(__isoc99_fscanf)
SCANNED(__isoc23_fscanf)
#undef SCANNED

#define SCANNED(symbol)                                                                                                \
  int symreal_outside_##symbol(char const *format, ...) asm(#symbol);                                                  \
  [[gnu::weak]] int symreal_outside_##symbol(char const *format, ...) {                                                \
    va_list arguments;                                                                                                 \
    va_start(arguments, format);                                                                                       \
    int const value = std::vscanf(format, arguments);                                                                  \
    va_end(arguments);                                                                                                 \
    note("scanf()", value);                                                                                            \
    return value;                                                                                                      \
  }
SCANNED(scanf)
SCANNED(__isoc99_scanf)
SCANNED(__isoc23_scanf)
#undef SCANNED

} // extern "C"

#endif
