// Pragmas that are no list of clauses, or have clauses that do not stand there.
// RUN: not %rewrite %s 2>&1 | FileCheck %s
double closed(double *x) {
  // CHECK-DAG: pragma_syntax.cpp:[[@LINE+1]]:29: error: expected ')' before the end of the line [SYM021]
#pragma symreal input(x[0:1]
  return x[0];
}
double external(double x) {
  // CHECK-DAG: pragma_syntax.cpp:[[@LINE+1]]:26: error: external(...) begins a pragma of its own [SYM021]
#pragma symreal input(x) external(f)
  return x;
}
void length(double *x) {
  // CHECK-DAG: pragma_syntax.cpp:[[@LINE+1]]:27: error: expected the length of the section after ':' [SYM021]
#pragma symreal input(x[0:])
}
void call(double *x) {
  // CHECK-DAG: pragma_syntax.cpp:[[@LINE+1]]:17: error: 'call' does not belong in a pragma in a block [SYM021]
#pragma symreal call(2)
}
void range(double x) {
  // CHECK-DAG: pragma_syntax.cpp:[[@LINE+1]]:26: error: range(low, high) stands after input(...) and has two numbers [SYM021]
#pragma symreal input(x) range(1) generate("range.c")
}
double nothing(double x) {
  // CHECK-DAG: pragma_syntax.cpp:[[@LINE+1]]:16: error: a clause is missing, such as input(q) [SYM021]
#pragma symreal
  return x;
}
