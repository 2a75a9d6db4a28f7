// The pattern of a matrix of derivatives stands in the header; with `sparse` the output is what is not zero, with `symmetric` the lower half.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/k.c --differentiate 'jacobian(y, x)' --differentiate 'hessian([cost, y], x, weighted, sparse, symmetric)' --differentiate 'vjp([cost, y], x)' --differentiate 'hessian(cost, x, symmetric)' --differentiate 'jacobian(cost, x)'
// RUN: FileCheck %s --check-prefix=HEADER --input-file=%t/k.h
// HEADER: double weights_cost_y[4];
// HEADER-NEXT: } input_values;
// HEADER: double jacobian_y_x[3][4];
// HEADER-NEXT: double hessian_cost_y_x[7];
// HEADER-NEXT: double vjp_cost_y_x[4];
// HEADER-NEXT: double hessian_cost_x[10];
// HEADER: The matrix jacobian_y_x: all elements are stored, and those listed are not zero by structure.
// HEADER: enum { jacobian_y_x_rows = 3, jacobian_y_x_columns = 4, jacobian_y_x_nonzeros = 6 };
// HEADER-NEXT: extern int const jacobian_y_x_row[6];
// HEADER: extern int const jacobian_y_x_row_start[4];
// HEADER-NEXT: extern int const jacobian_y_x_column_start[5];
// HEADER: The matrix hessian_cost_y_x: those listed are stored, in this order; the matrix is symmetric
// HEADER: The matrix jacobian_cost_x: no element is zero by structure.
// HEADER-NEXT: enum { jacobian_cost_x_rows = 1, jacobian_cost_x_columns = 4, jacobian_cost_x_nonzeros = 4 };
// HEADER-NOT: jacobian_cost_x_row[
// RUN: FileCheck %s --check-prefix=LISTS --input-file=%t/k.c
// LISTS: int const jacobian_y_x_row[6] = {
// LISTS-NEXT: 0, 0, 1, 1, 2, 2};
// LISTS: int const jacobian_y_x_column[6] = {
// LISTS-NEXT: 0, 1, 1, 2, 2, 3};
// LISTS: int const jacobian_y_x_row_start[4] = {
// LISTS-NEXT: 0, 2, 4, 6};
// LISTS: int const jacobian_y_x_column_start[5] = {
// LISTS-NEXT: 0, 1, 3, 5, 6};
// LISTS: int const jacobian_y_x_row_by_column[6] = {
// LISTS-NEXT: 0, 0, 1, 1, 2, 2};
// LISTS: int const jacobian_y_x_by_column[6] = {
// LISTS-NEXT: 0, 1, 2, 3, 4, 5};
// RUN: cc -std=c99 -pedantic -Wall -Wextra -Werror -c %t/k.c -o %t/k.o
// RUN: %symreal verify %s %t/k.c --samples=200 2>&1 | FileCheck %s
// CHECK: jacobian_y_x[{{.*}}] {{ *}}12 {{.*}} 0 {{ *}}{{[0-9]+}} of
// CHECK-NEXT: hessian_cost_y_x[{{.*}}] {{ *}}16 {{.*}} 0 {{ *}}{{[0-9]+}} of
// A packed element that is wrong is found: here one is left 0.
// RUN: sed 's/output\[16\] = .*/output[16] = 0.0;/' %t/k.c > %t/wrong.c && cp %t/k.h %t/wrong.h
// RUN: not %symreal verify %s %t/wrong.c --samples=200 2>&1 | FileCheck %s --check-prefix=WRONG
// WRONG: elements of derivatives differ from those of the original [SYM091]
// The packed Jacobian is what the dense one has in these places, and other languages have the lists as well.
// RUN: %symreal generate %s -o %t/packed.c --graph %t/k.graph --prefix packed --differentiate 'jacobian(y, x, sparse)' --lang=c,cpp,python,julia,javascript,go,rust
// RUN: cp %S/Inputs/packed.c %t/main.c && cc -std=c99 -Wall -Werror -I %t %t/main.c %t/k.c %t/packed.c -lm -o %t/main && %t/main
// RUN: FileCheck %s --check-prefix=CPP --input-file=%t/packed.hpp
// CPP: inline constexpr int const jacobian_y_x_row[6] = {
// RUN: c++ -std=c++20 -Wall -Werror -c %t/packed.cpp -o %t/cpp.o
// RUN: FileCheck %s --check-prefix=PYTHON --input-file=%t/packed.py
// PYTHON: {{(packed_)?}}jacobian_y_x_nonzeros = 6
// PYTHON: {{(packed_)?}}jacobian_y_x_column = numpy.array([
// RUN: FileCheck %s --check-prefix=JULIA --input-file=%t/packed.jl
// JULIA: const jacobian_y_x_column = Int[
// JULIA-NEXT: 1, 2, 2, 3, 3, 4]
// RUN: FileCheck %s --check-prefix=RUST --input-file=%t/packed.rs
// RUST: pub static {{.*}}JACOBIAN_Y_X_ROW: [usize; 6] = [
// What a graph says of its matrices is read back.
// RUN: %symreal opt %t/k.graph --differentiate 'jacobian(y, x, sparse)' --passes=none > %t/with.graph && FileCheck %s --check-prefix=GRAPH < %t/with.graph
// GRAPH: matrix 2 [3] [4] packed = 0 0 0 1 1 1 1 2 2 2 2 3
// RUN: %symreal opt %t/with.graph --passes=none | diff %t/with.graph -
// RUN: sed 's/packed = 0 0/packed = 9 0/' %t/with.graph > %t/bad.graph && not %symreal opt %t/bad.graph --passes=none 2>&1 | FileCheck %s --check-prefix=BAD
// BAD: a matrix has no such row or column
#include <math.h>
#include <stdio.h>

void k(double const *x, double *y, double *cost) {
  *cost = 0;
  for (int i = 0; i < 3; i++) y[i] = sin(x[i]) * x[i + 1];
  for (int i = 0; i < 4; i++) *cost += x[i] * x[i];
}

int main(void) {
  double x[4] = {0.5, 1.25, -0.75, 2}, y[3], cost;
#pragma symreal input(x[0:4]) range(-2, 2)
  k(x, y, &cost);
#pragma symreal output(y[0:3]) output(cost) generate("k.c")
  printf("%g %g\n", y[0], cost);
  return 0;
}
