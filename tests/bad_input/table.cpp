// What table(...) cannot be said of, and tables that cannot be recorded.
// RUN: not %symreal generate %s -o %t.c -- -DOBJECT 2>&1 | FileCheck %s --check-prefix=OBJECT
// OBJECT: table.cpp:[[#@LINE+10]]:{{[0-9]+}}: error: table() needs a pointer and an extent, as in table(t[0:n]) [SYM026]
// RUN: not %symreal generate %s -o %t.c -- -DOUTSIDE 2>&1 | FileCheck %s --check-prefix=OUTSIDE
// OUTSIDE: table.cpp:[[#@LINE+13]]:{{[0-9]+}}: error: 't' has 4 elements, and the index trunc(x) is 7 [SYM068]
// Without its extent a pointer is no table: its element is decided.
// RUN: not %symreal generate %s -o %t.c -- -DUNKNOWN 2>&1 | FileCheck %s --check-prefix=UNKNOWN
// UNKNOWN: table.cpp:[[#@LINE+10]]:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of trunc(x)
static double const values[4] = {1, 2, 4, 8};
#pragma symreal function input(x) output(return)
double f(double x, double const *t) {
#if defined(OBJECT)
#pragma symreal table(t)
#elif !defined(UNKNOWN)
#pragma symreal table(t[0:4])
#endif
  int const k = (int)x;
  return x * t[k];
}
int main(int, char **) {
#ifdef OUTSIDE
  return f(7.5, values) > 1;
#else
  return f(1.5, values) > 1;
#endif
}
