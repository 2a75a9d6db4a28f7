// What comes from outside of the program while a kernel is recorded is baked in, and told like other hidden state.
// RUN: rm -f %t.c && echo 3.5 > %t.gain
// RUN: not %symreal generate %s -o %t.c --run-args=%t.gain 2>&1 | FileCheck %s
// RUN: not ls %t.c
// RUN: %symreal generate %s -o %t.c --run-args=%t.gain --frozen=warn 2>&1 | FileCheck %s --check-prefix=WARNING
// RUN: FileCheck %s --check-prefix=HEADER < %t.h
// RUN: %symreal generate %s -o %t.c --run-args=%t.gain -- -DBEFORE 2>&1 | FileCheck %s --check-prefix=BEFORE --implicit-check-not="[SYM"
// BEFORE: kernel mixed

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <random>

struct Outside {
  double chance, uniform, seconds, ticks, gain, second_gain, device;
  bool verbose;
};

Outside look(char const *file_name) {
  Outside now;
  now.chance = std::rand() % 100;
  now.uniform = drand48();
  now.seconds = static_cast<double>(std::time(nullptr));
  now.ticks = static_cast<double>(std::chrono::steady_clock::now().time_since_epoch().count());
  now.verbose = std::getenv("SIMULATION_VERBOSE") != nullptr;
  std::FILE *file = std::fopen(file_name, "r");
  double gain = 0;
  if (std::fscanf(file, "%lf", &gain) != 1) std::abort();
  std::fclose(file);
  now.gain = gain;
  std::ifstream stream(file_name);
  stream >> now.second_gain;
  now.device = std::random_device()();
  return now;
}

#pragma symreal function input(x) output(return)
double mixed(double x, Outside const &given, char const *file_name) {
#ifdef BEFORE
  (void)given, (void)file_name;
  return x * x;
#else
  Outside const now = look(file_name);
  return x * now.chance + now.uniform + now.seconds + now.ticks + now.gain + now.second_gain + now.device +
         (now.verbose ? 1 : 2);
#endif
}

int main(int, char **arguments) { std::printf("%g\n", mixed(0.5, look(arguments[1]), arguments[1])); }

// CHECK-DAG: outside.cpp:24:{{[0-9]+}}: error: kernel 'mixed' reads 'rand()' ({{[0-9]+}}), which is neither input nor parameter [SYM017]
// CHECK-DAG: outside.cpp:25:{{[0-9]+}}: error: kernel 'mixed' reads 'drand48()' (0.{{[0-9]+}}), which
// CHECK-DAG: outside.cpp:26:{{[0-9]+}}: error: kernel 'mixed' reads 'time()' (
// CHECK-DAG: outside.cpp:27:{{[0-9]+}}: error: kernel 'mixed' reads 'clock_gettime()' (
// CHECK-DAG: outside.cpp:28:{{[0-9]+}}: error: kernel 'mixed' reads 'getenv()', which
// CHECK-DAG: outside.cpp:31:{{[0-9]+}}: error: kernel 'mixed' reads 'fscanf()' (1), which
// CHECK-DAG: outside.cpp:35:{{[0-9]+}}: error: kernel 'mixed' reads 'read()' (
// CHECK-DAG: outside.cpp:36:{{[0-9]+}}: error: kernel 'mixed' reads 'std::random_device' (
// WARNING: warning: kernel 'mixed' reads 'rand()'
// WARNING: baked in {{.*}}rand() = 
// HEADER: Baked in
// HEADER: rand() = 
