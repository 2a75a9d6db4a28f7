// Text and bytes that library code writes into static objects of the program are state as well.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not="[SYM"
// RUN: not ls %t.c
// RUN: %symreal generate %s -o %t.c -- -DDECLARED 2>&1 | FileCheck %s --check-prefix=DECLARED --implicit-check-not="[SYM"
// DECLARED: kernel step
// RUN: %symreal verify %s %t.c --samples=100 -- -DDECLARED

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

static std::uint8_t seen[16];
char message[32];
static std::string name = "a";
static char untouched[8] = "same";

#ifdef DECLARED
#pragma symreal function input(x) scratch(seen, message, name) output(return)
#else
#pragma symreal function input(x) output(return)
#endif
double step(double x) {
  char local[16];
  std::strcpy(local, untouched);
  std::sprintf(reinterpret_cast<char *>(seen), "%d", 42);
  std::strcpy(message, local);
  name += "b";
  return x * x;
}

int main() { std::printf("%g %s %s %s\n", step(0.5), message, reinterpret_cast<char *>(seen), name.c_str()); }

// CHECK-DAG: error: the kernel writes 'seen', which is not an output [SYM053]
// CHECK-DAG: error: the kernel writes 'message', which is not an output [SYM053]
// CHECK-DAG: error: the kernel changes bytes 1 to 3 of 'message' (static, 32 bytes), which is not an output [SYM053]
// CHECK-DAG: error: the kernel writes 'name', which is not an output [SYM053]
// CHECK: help:
