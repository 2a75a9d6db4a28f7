// What a library gives that nobody has declared is baked in, and told like other state; what the standard library gives
// for constants is not worth a word.
// RUN: rm -rf %t && mkdir %t && cp %s %t/library.cpp && %cxx -I%S/Inputs/library -c %S/Inputs/library/sensor.cpp -o %t/sensor.o
// RUN: %same %t/library.cpp -- -I%S/Inputs/library
// RUN: cd %t && not %symreal generate library.cpp -o k.c --kernel=k --link sensor.o -- -I%S/Inputs/library 2>&1 | FileCheck %s --implicit-check-not="strlen" --implicit-check-not="half()"
// RUN: not ls %t/k.c
// RUN: cd %t && %symreal generate library.cpp -o k.c --kernel=k --link sensor.o --frozen=allow -- -I%S/Inputs/library 2>&1 | FileCheck %s --check-prefix=LISTED
// RUN: cd %t && %symreal verify library.cpp k.c --link sensor.o --samples=100 -- -I%S/Inputs/library
// RUN: cd %t && %symreal generate library.cpp -o k.c --link sensor.o --kernel=declared -- -DDECLARED -I%S/Inputs/library 2>&1 | FileCheck %s --check-prefix=DECLARED --implicit-check-not="[SYM"
// DECLARED: kernel declared
#include <sensor.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#pragma symreal external(sensor_scaled) pure
#pragma symreal function input(x) output(return)
double declared(double x) { return x * sensor_scaled(2.0); }

#ifndef DECLARED
#pragma symreal function input(x) output(return)
double k(double x) {
  sensor::Device device;
  // CHECK-DAG: library.cpp:[[@LINE+1]]:{{[0-9]+}}: error: kernel 'k' reads 'sensor_gain()' (2.5), which is neither input nor parameter [SYM017]
  double y = x * sensor_gain();
  // CHECK-DAG: library.cpp:[[@LINE+1]]:{{[0-9]+}}: error: kernel 'k' reads 'sensor_count()' (5), which is
  y += sensor_count(2) + std::strlen("abc") + std::abs(-3) + std::atof("2");
  // CHECK-DAG: library.cpp:[[@LINE+1]]:{{[0-9]+}}: error: kernel 'k' reads 'sensor::shifted()' (1), which is
  y += sensor::shifted() * sensor::half();
  // CHECK-DAG: library.cpp:[[@LINE+1]]:{{[0-9]+}}: error: kernel 'k' reads 'sensor::Device::bias()' (0.25), which is
  return y + device.bias();
}
// LISTED: baked in {{.*}}sensor_gain() = 2.5
#else
double k(double x) { return x; }
#endif

int main() { std::printf("%g %g\n", k(2), declared(1)); }
