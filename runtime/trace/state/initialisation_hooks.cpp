// Hooks for the functions that the compiler calls around the initialisation of a function-local static variable, in the
// whole symbolic program: the variable's value at the end of it belongs to the first call, later writes to their own
// calls.
//
// Weak, so that a program with functions of such names has its own.
#include "runtime/memory/heap_blocks.h"
#include "runtime/memory/own_memory.h"
#include "runtime/trace/state/state.h"

#ifdef __GLIBC__

#include <dlfcn.h>

namespace {

using symreal::trace::session;

// The library's; null in a program that has the C++ library within itself. A static variable here would need a guard.
template <class Function> Function *original(Function *&known, char const *name) {
  if (!known) known = reinterpret_cast<Function *>(dlsym(RTLD_NEXT, name));
  return known;
}

bool is_watched() { return symreal::detail::recording && !symreal::memory::OwnWork::is_going_on(); }

} // namespace

extern "C" {

char symreal_initialisation_hooks = 0;

// The first byte of a guard says whether the variable is initialised.
int symreal_initialisation_acquire(char *guard) asm("__cxa_guard_acquire");
[[gnu::weak]] int symreal_initialisation_acquire(char *guard) {
  static int (*known)(char *) = nullptr;
  auto *const acquire = original(known, "__cxa_guard_acquire");
  int const begins = acquire ? acquire(guard) : *guard == 0;
  if (begins && is_watched()) {
    symreal::trace::Pause const pause;
    session().state.begin_initialisation(guard);
  }
  return begins;
}

void symreal_initialisation_release(char *guard) asm("__cxa_guard_release");
[[gnu::weak]] void symreal_initialisation_release(char *guard) {
  static void (*known)(char *) = nullptr;
  if (auto *const release = original(known, "__cxa_guard_release"))
    release(guard);
  else
    *guard = 1;
  if (!is_watched()) return;
  symreal::trace::Pause const pause;
  session().state.end_initialisation(guard);
}

void symreal_initialisation_abort(char *guard) asm("__cxa_guard_abort");
[[gnu::weak]] void symreal_initialisation_abort(char *guard) {
  static void (*known)(char *) = nullptr;
  if (auto *const abort = original(known, "__cxa_guard_abort")) abort(guard);
  if (!is_watched()) return;
  symreal::trace::Pause const pause;
  session().state.give_up_initialisation(guard);
}

} // extern "C"

#endif
