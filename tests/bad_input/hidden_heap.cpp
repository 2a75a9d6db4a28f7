// What containers and heap blocks hold that are older than the kernel; its own are its own.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <numeric>
#include <vector>

struct Table {
  std::vector<double> weights;
  std::unique_ptr<double[]> offsets;
  double *scale;
};

double own_memory(double x) {
  std::vector<double> powers(3, 1.0);
  double *half = static_cast<double *>(std::malloc(sizeof(double)));
  *half = 0.5;
  half = static_cast<double *>(std::realloc(half, 400 * sizeof(double)));
  for (int i = 1; i < 3; i++) powers[i] = powers[i - 1] * x;
  double const result = *half * std::accumulate(powers.begin(), powers.end(), 0.0);
  std::free(half);
  return result;
}

#pragma symreal function input(x) output(y[0:6])
void evaluate(Table const &table, double const *raw, double x, double *y) {
  y[0] = own_memory(x);
  y[1] = x * table.weights[1];
  y[2] = x * table.offsets[0] + *table.scale;
  y[3] = x * std::accumulate(table.weights.begin(), table.weights.end(), 0.0);
  std::vector<double> const copy(raw, raw + 2);
  y[4] = x * copy[0];
  double moved[2];
  std::memcpy(moved, raw + 2, sizeof moved);
  y[5] = x * moved[1];
}

int main() {
  double scale = 7, y[6], raw[] = {21, 22, 23, 24};
  Table const table{{1, 2, 3}, std::make_unique<double[]>(2), &scale};
  evaluate(table, raw, 0.5, y);
  std::printf("%g\n", y[0]);
}

// CHECK: hidden_heap.cpp:32:14: error: kernel 'evaluate' reads 'table.weights[1]' (2), which is
// CHECK: hidden_heap.cpp:33:14: error: kernel 'evaluate' reads 'table.offsets[0]' (0), which is
// CHECK: hidden_heap.cpp:33:33: error: kernel 'evaluate' reads '*table.scale' (7), which is
// CHECK: hidden_heap.cpp:34:{{[0-9]+}}: error: kernel 'evaluate' reads 'table.weights' (1, 3), which are
// CHECK: hidden_heap.cpp:35:34: error: kernel 'evaluate' reads 'raw' (21, 22), which are
// CHECK: hidden_heap.cpp:38:3: error: kernel 'evaluate' reads 'raw + 2' (23, 24), which are neither input nor parameter [SYM017]
// CHECK-NOT: SYM017]
