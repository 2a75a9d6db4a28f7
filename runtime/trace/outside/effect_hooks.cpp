// Changes by a kernel of the state that the C library and the C++ library keep for the whole program. The functions
// that change it are replaced in the whole symbolic program and in the original, and call the library's.
//
// Weak, so that a program with a function of such a name has its own.
#include "runtime/trace/outside/world.h"

#ifdef __GLIBC__

#include <cstddef>
#include <dlfcn.h>

extern "C" {

char symreal_effect_hooks = 0;

#define EFFECT(result, symbol, when, what, parameters, arguments)                                                      \
  result symreal_effect_##symbol parameters asm(#symbol);                                                              \
  [[gnu::weak]] result symreal_effect_##symbol parameters {                                                            \
    using Function = result(*) parameters;                                                                             \
    static auto const original = reinterpret_cast<Function>(dlsym(RTLD_NEXT, #symbol));                                \
    if (when) symreal::trace::note_effect(what);                                                                       \
    return original arguments;                                                                                         \
  }
#include "runtime/trace/outside/effects.def"
#undef EFFECT

// The C library links atexit into each program statically, so the hook forwards to __cxa_atexit.
int symreal_library_atexit(void (*function)(void *), void *argument, void *library) asm("__cxa_atexit");
int symreal_effect_atexit(void (*function)()) asm("atexit");
[[gnu::weak]] int symreal_effect_atexit(void (*function)()) {
  symreal::trace::note_effect("registers a function for the end of the program");
  return symreal_library_atexit([](void *each) { reinterpret_cast<void (*)()>(each)(); },
                                reinterpret_cast<void *>(function), nullptr);
}

} // extern "C"

#endif
