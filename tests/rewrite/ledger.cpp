// No double that is compiled is left out: what has no type in the syntax tree is converted, with a word about it.
// RUN: %rewrite %s 2> %t.err | FileCheck %s
// RUN: FileCheck --check-prefix=NOTED %s < %t.err
// RUN: %same %s
template <class T> T twice(T x) { return x + x; }
// NOTED-DAG: ledger.cpp:[[@LINE+2]]:10: warning: {{.*}} it becomes REAL [SYM041]
// CHECK: template REAL twice<REAL>(REAL);
template double twice<double>(double);
template <class T> struct Box { T x; };
// CHECK: template struct Box<REAL>;
template struct Box<double>;
// CHECK: alignas(REAL) char bytes[8];
alignas(double) char bytes[8];
// CHECK: #if 0
#if 0
// CHECK: double inactive;
double inactive;
#endif
// CHECK: long double a; double long b; long const double c = 0;
long double a; double long b; long const double c = 0;
// CHECK: struct To { REAL_MEMBERS(public, v) operator REAL() const; friend REAL f(REAL); REAL v; };
struct To { operator double() const; friend double f(double); double v; };
// CHECK: REAL call(To const &t) { return t.operator REAL(); }
double call(To const &t) { return t.operator double(); }
To::operator double() const { return v; }
