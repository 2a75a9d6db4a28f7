// What is no external function, and why.
// RUN: not %rewrite %s 2>&1 | FileCheck %s
class Hidden;
extern "C" {
double fine(double x);
double unsized(double const *x);
double reads(void *file);
void strange(Hidden const *x, float y, double (*callback)(double));
int count(char const *format, ...);
double ours(double x) { return x; }
double sized(double const *x, int n, double y, double m[2][3]);
static double inside(double x);
}
double cpp(double x);

// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:26: error: no function 'missing' is declared in this file [SYM023]
#pragma symreal external(missing)
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:26: error: 'cpp' has C++ linkage: the generated C cannot name it [SYM044]
#pragma symreal external(cpp)
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:26: error: 'inside' has C++ linkage: the generated C cannot name it [SYM044]
#pragma symreal external(inside)
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:26: error: 'ours' is defined in the sources
#pragma symreal external(ours)
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:26: error: 'count' has no prototype that tells its parameters
#pragma symreal external(count)
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:26: error: parameter 'x' of 'unsized' does not say how many doubles it points to [SYM044]
#pragma symreal external(unsized)
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:26: error: parameter 'file' of 'reads' is void *, which does not point to doubles
#pragma symreal external(reads)
// CHECK-DAG: external_bad.cpp:[[@LINE+3]]:26: error: parameter 'x' of 'strange' is const Hidden *, which does not point to doubles
// CHECK-DAG: external_bad.cpp:[[@LINE+2]]:26: error: parameter 'y' of 'strange' is float, and neither a number, an integer nor made of doubles
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:26: error: parameter 'callback' of 'strange' is double (*)(double), which does not point to doubles
#pragma symreal external(strange)
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:47: error: 'z' is not a parameter of 'sized' [SYM023]
#pragma symreal external(sized) input(x[0:3], z[0:2])
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:39: error: 'y' is not an array
#pragma symreal external(sized) input(y[0:3], x[0:1])
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:26: error: parameter 'x' of 'sized' has the size 'y', which is neither a number nor an integer parameter
#pragma symreal external(sized) input(x[0:y])
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:40: error: 'x' points to const and cannot be an output
#pragma symreal external(sized) output(x[0:n])
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:26: error: parameter 'm' of 'sized' is declared with another size than '4'
#pragma symreal external(sized) input(x[0:n], m[0:2][0:4])
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:41: error: an array of an external function begins at 0 [SYM021]
#pragma symreal external(sized) input(x[1:2])
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:32: error: beside external(...) stand pure, input(...), output(...) and derivative(...) [SYM021]
#pragma symreal external(fine) parameter(x)
// CHECK-DAG: external_bad.cpp:[[@LINE+1]]:26: error: expected '(' after 'external' [SYM021]
#pragma symreal external fine

#pragma symreal external(fine)
// CHECK-DAG: external_bad.cpp:[[@LINE+2]]:{{[0-9]+}}: error: the language does not say which of these external functions is called first [SYM044]
// CHECK-DAG: note: put the calls into statements of their own, or say that they are pure
double order(double x) { return fine(x) - fine(2 * x); }
