// A function-try-block: what its handlers return is the kernel's result, too, and a thrown literal is a REAL.
// RUN: rm -rf %t && mkdir %t
// RUN: %same %s
// RUN: %rewrite %s | FileCheck %s
// RUN: %symreal generate %s -o %t/
// RUN: %symreal verify %s %t/kernel.c --kernel kernel --samples=100
// RUN: %symreal verify %s %t/thrown.c --kernel thrown --samples=100
// RUN: %symreal verify %s %t/written.c --kernel written --samples=100 && FileCheck %s --check-prefix=WRITTEN < %t/written.c
// RUN: %symreal verify %s %t/of.c --kernel of --samples=100
#include <cstdio>

double called(double x) try {
  // CHECK: throw REAL_C(1.5);
  if (sizeof(int) == 4) throw 1.5;
  return x;
} catch (double factor) {
  return factor * x;
}
template <class T> T generic(T x) try { return x * 2; } catch (...) { return T(0); }
struct Made {
  double value;
  explicit Made(double x) try : value(x * 2) { value += 1; } catch (...) { std::puts("never"); }
  double get() const try { return value; } catch (int) { return 0; }
};
struct Pair {
  double a, b;
};

// CHECK: Pair kernel(REAL x) SYMREAL_TRY_BEGIN SYMREAL_FUNCTION("kernel", {{.*}} SYMREAL_OUTPUTS_END try { return
#pragma symreal function input(x) output(return)
Pair kernel(double x) try { return {called(x) + generic(x), Made(x).get()}; } catch (...) { return {0, 0}; }

#pragma symreal function input(x) output(return)
double thrown(double x) try {
  if (sizeof(int) == 4) throw x * 2;
  return x;
} catch (int) {
  return 0.0;
} catch (double y) {
  return y + 1;
  // CHECK: } SYMREAL_TRY_END
}

// The output is read when the handler has run.
// WRITTEN: input[0]*3.0
#pragma symreal function input(x) output(y)
void written(double x, double &y) try {
  y = x * 2;
  if (sizeof(int) == 4) throw 3;
} catch (int factor) {
  y = factor * x;
}

struct Law {
  double factor = 2;
#pragma symreal function input(x) output(return) constant(factor)
  double of(double x) const noexcept try { return x * factor; } catch (...) { return 0.0; }
};

int main() {
  double y;
  written(0.5, y);
  std::printf("%g\n", kernel(0.5).b + thrown(0.5) + y + Law{}.of(0.5));
}
