// What follows a base class that is an instantiation cannot be kept out of its padding.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cstdio>

template <class T> struct Node {
  T value;
  int next;
};
// CHECK: class_layout.cpp:[[@LINE+1]]:8: error: what follows 'Node' in 'Leaf' would begin in its padding [SYM132]
struct Leaf : Node<double> {
  int weight;
};

int main() {
  double x = 1.0, y;
#pragma symreal input(x)
  y = x * sizeof(Leaf);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
