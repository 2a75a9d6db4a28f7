// A macro hands an argument down to one that prints it, and computes with it besides; a macro in the argument says
// `double`. What is computed is converted; in symbolic mode the text says so.
// RUN: %same %s
// RUN: %rewrite %s | FileCheck %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100
#include <complex>
#include <limits>

#define TEXT_(x) #x
#define TEXT(x) TEXT_(x)
#define PASS(x) x, TEXT(x)
#define COMPARE(a, b) do { is_equal = differ(a, PASS(b)); } while (0)
#define CLOSE(a, b) COMPARE((a), shifted(b))
// CHECK: #define EPSILON ((std::numeric_limits<REAL>::epsilon)())
#define EPSILON ((std::numeric_limits<double>::epsilon)())
// Where words are pasted, the invocation is written out, also in an argument that is used twice.
#define double_unit 0.25
#define PASTE_(type, what) type##_##what
#define PASTE(type, what) PASTE_(type, what)
#define number double
#define WITH(a, b) ((a) + (a) + shifted(b))

char const *text = "";
double shifted(double x) { return x + 1; }
double differ(double a, double b, char const *what) {
  text = what;
  return a - b;
}

int main() {
  std::complex<double> x[1] = {{2, 1}};
  double is_equal, y;
#pragma symreal input(x) scratch(text)
  // CHECK: {{^}}  CLOSE(std::abs(x[0] - REAL_C(1.0)), 2 * EPSILON);
  CLOSE(std::abs(x[0] - 1.0), 2 * EPSILON);
  // CHECK: y = WITH(REAL_PASTED((0.25), PASTE(number, unit)), REAL_PASTED((0.25), PASTE(number, unit))) * is_equal;
  y = WITH(PASTE(number, unit), PASTE(number, unit)) * is_equal;
#pragma symreal output(is_equal, y) generate("close.c")
  return text[0] != 's';
}
