// A structure that leaves open what is in it cannot be annotated as a whole.
// RUN: rm -rf %t && split-file %s %t && cd %t
// RUN: not %symreal generate union.cpp -o y.c 2>&1 | FileCheck union.cpp
// RUN: not %symreal generate virtual.cpp -o y.c 2>&1 | FileCheck virtual.cpp
//--- union.cpp
struct Value {
  int kind;
  union {
    double number;
    long count;
  };
};
struct Cell {
  Value value;
};
// CHECK: union.cpp:[[@LINE+2]]:32: error: 'cell' has a member 'value.(anonymous)', which is a union
// CHECK-SAME: and which of its members counts is not known: name the numbers that are meant [SYM026]
#pragma symreal function input(cell) output(return)
double twice(Cell const &cell) { return 2 * cell.value.number; }
int main() { return 0; }
//--- virtual.cpp
struct Base {
  double x;
};
struct Derived : virtual Base {
  double y;
};
// CHECK: virtual.cpp:[[@LINE+1]]:32: error: 'd' has a virtual base: name the numbers that are meant [SYM026]
#pragma symreal function input(d) output(return)
double sum(Derived const &d) { return d.x + d.y; }
int main() { return 0; }
