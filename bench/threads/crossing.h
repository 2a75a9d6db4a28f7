/* How the threads of bench/threads wait for each other: they spin. */
#ifndef CROSSING_H
#define CROSSING_H

#define _GNU_SOURCE
#include <sched.h>
#include <stdatomic.h>

/* A value that crosses has a cache line of its own, and says which call it belongs to. */
struct crossing {
  _Alignas(64) double value;
  atomic_int call;
};
static inline void relax(int *spins) {
#if defined __x86_64__ || defined __i386__
  __builtin_ia32_pause();
#endif
  if (++*spins == 20000) *spins = 0, sched_yield();
}
static inline void wait_for(atomic_int *number, int value) {
  for (int spins = 0; atomic_load_explicit(number, memory_order_acquire) != value;) relax(&spins);
}
static inline void give(struct crossing *to, double value, int call) {
  to->value = value;
  atomic_store_explicit(&to->call, call, memory_order_release);
}
static inline double take(struct crossing *from, int call) {
  wait_for(&from->call, call);
  return from->value;
}
void block_0(double const *input, double *output, int call);
void block_1(double const *input, double *output, int call);

#endif
