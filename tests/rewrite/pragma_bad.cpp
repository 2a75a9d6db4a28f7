// Each malformed or misplaced pragma has its diagnostic, and its place.
// RUN: split-file %s %t
// RUN: cd %t && not %rewrite a.cpp 2>&1 | FileCheck %s --check-prefix=A
// RUN: cd %t && not %rewrite b.cpp 2>&1 | FileCheck %s --check-prefix=B
// RUN: cd %t && not %rewrite c.cpp 2>&1 | FileCheck %s --check-prefix=C
// RUN: cd %t && not %rewrite d.cpp 2>&1 | FileCheck %s --check-prefix=D
// RUN: cd %t && not %rewrite e.cpp 2>&1 | FileCheck %s --check-prefix=E
// RUN: cd %t && not %rewrite f.cpp 2>&1 | FileCheck %s --check-prefix=F
// RUN: cd %t && not %rewrite g.cpp 2>&1 | FileCheck %s --check-prefix=G
// RUN: cd %t && not %rewrite h.cpp 2>&1 | FileCheck %s --check-prefix=H
// RUN: cd %t && not %rewrite i.cpp 2>&1 | FileCheck %s --check-prefix=I
// RUN: cd %t && not %rewrite j.cpp 2>&1 | FileCheck %s --check-prefix=J
// RUN: cd %t && not %rewrite k.cpp 2>&1 | FileCheck %s --check-prefix=K
// RUN: cd %t && not %rewrite l.cpp 2>&1 | FileCheck %s --check-prefix=L
// RUN: cd %t && not %rewrite m.cpp 2>&1 | FileCheck %s --check-prefix=M
// RUN: cd %t && not %rewrite n.cpp 2>&1 | FileCheck %s --check-prefix=N
// RUN: cd %t && not %rewrite o.cpp 2>&1 | FileCheck %s --check-prefix=O
// RUN: cd %t && not %rewrite p.cpp 2>&1 | FileCheck %s --check-prefix=P
// RUN: cd %t && not %rewrite q.cpp 2>&1 | FileCheck %s --check-prefix=Q
// RUN: cd %t && not %rewrite r.cpp 2>&1 | FileCheck %s --check-prefix=R
// RUN: cd %t && not %rewrite s.cpp 2>&1 | FileCheck %s --check-prefix=S
//--- a.cpp
// A: a.cpp:4:29: error: expected ')' before the end of the line [SYM021]
void f(double *x) {
  x[0] = 1;
#pragma symreal input(x[0:1]
}
//--- b.cpp
void f(double x) {
// B: b.cpp:3:17: error: unknown clause 'inputs' [SYM022]
#pragma symreal inputs(x)
}
//--- c.cpp
void f(double x) {
// C: c.cpp:3:26: error: use of undeclared identifier 'yy' [SYM023]
#pragma symreal input(x, yy) generate("c.c")
}
//--- d.cpp
void f(double x) {
  if (x > 0)
// D: d.cpp:4:1: error: this pragma stands where no statement can stand [SYM024]
#pragma symreal input(x) generate("d.c")
    x = 1;
}
//--- e.cpp
double x;
// E: e.cpp:3:1: error: this pragma stands where no statement can stand [SYM024]
#pragma symreal input(x)
//--- f.cpp
void f(double) {
  double a,
// F: f.cpp:4:1: error: this pragma stands where no statement can stand [SYM024]
#pragma symreal generate("f.c")
  b;
}
//--- g.cpp
// G: g.cpp:2:1: error: no function definition follows this pragma [SYM025]
#pragma symreal function input(x) output(return)
double f(double x);
double f(double x) { return x; }
//--- h.cpp
// H: h.cpp:2:35: error: 'z' is neither a parameter of 'f' nor declared before it [SYM023]
#pragma symreal function input(x, z) output(return)
double f(double x) { return x; }
//--- i.cpp
// I: i.cpp:2:32: error: 'x' is a pointer and needs an extent: '*x' for one object, or 'x[0:n]' [SYM026]
#pragma symreal function input(x) output(return)
double f(double *x) { return x[0]; }
//--- j.cpp
// J: j.cpp:2:32: error: 'n' holds no double: it is int [SYM026]
#pragma symreal function input(n) output(return)
double f(int n) { return n; }
//--- k.cpp
double f() {
  double const x = 1.0;
// K: k.cpp:4:23: error: 'x' is const: the compiler may have used its value already [SYM026]
#pragma symreal input(x)
#pragma symreal output(x) generate("k.c")
  return x;
}
//--- l.cpp
double f(double x) {
// L: l.cpp:3:26: error: external(...) begins a pragma of its own [SYM021]
#pragma symreal input(x) external(f)
  return x;
}
//--- m.cpp
double f(double x) {
// M: m.cpp:3:1: error: no generate("...") follows these annotations [SYM028]
#pragma symreal input(x)
  return x;
}
//--- n.cpp
// N: n.cpp:2:1: error: this pragma has no output(...) [SYM028]
#pragma symreal function input(x)
double f(double x) { return x; }
//--- o.cpp
void f(double *x) {
// O: o.cpp:3:27: error: expected the length of the section after ':' [SYM021]
#pragma symreal input(x[0:])
}
//--- p.cpp
void f(double *x) {
// P: p.cpp:3:17: error: 'call' does not belong in a pragma in a block [SYM021]
#pragma symreal call(2)
}
//--- q.cpp
void f(double x) {
// Q: q.cpp:3:26: error: range(low, high) stands after input(...) and has two numbers [SYM021]
#pragma symreal input(x) range(1) generate("q.c")
}
//--- r.cpp
// R: r.cpp:2:42: error: 'f' returns nothing [SYM026]
#pragma symreal function input(x) output(return)
void f(double x) {}
//--- s.cpp
double f(double x) {
// S: s.cpp:3:16: error: a clause is missing, such as input(q) [SYM021]
#pragma symreal
  return x;
}
