// A program with an allocator of its own: which memory is the kernel's is not known, and said so. Static objects are
// still looked at.
// RUN: %symreal generate %s -o %t.c --frozen=warn 2>&1 | FileCheck %s
// RUN: %symreal generate %s -o %t.c --frozen=warn -- -fsanitize=address -DNO_ALLOCATOR 2>&1 | FileCheck %s
// CHECK: warning: Symreal did not look at what the kernel reads through pointers and from members{{.*}} [SYM065]
// CHECK: help:
// CHECK: warning: kernel 'scale' reads 'gain' (3), which is
// CHECK: wrote
#include <cstdio>
#include <cstdlib>
#include <cstring>

#ifndef NO_ALLOCATOR
alignas(16) static char pool[1 << 24];
static std::size_t used = 0;
extern "C" {
void *malloc(std::size_t size) {
  void *block = pool + used;
  used += (size + 15) / 16 * 16;
  return block;
}
void free(void *) {}
void *calloc(std::size_t count, std::size_t size) { return malloc(count * size); }
void *realloc(void *block, std::size_t size) {
  void *larger = malloc(size);
  return block ? std::memmove(larger, block, size) : larger;
}
}
#endif

double gain = 3;

#pragma symreal function input(x) output(return)
double scale(double *factor, double x) { return gain * *factor * x; }

int main() {
  double *factor = static_cast<double *>(std::malloc(sizeof(double)));
  *factor = 2.0;
  std::printf("%g\n", scale(factor, 0.5));
  std::free(factor);
}
