// A template whose instantiation on double is the kernel; that on float is an ordinary function, and may run first.
// RUN: rm -rf %t && %symreal generate %s -o %t/ --decisions=auto
// RUN: FileCheck %s --input-file=%t/k.c && FileCheck %s --check-prefix=STEP --input-file=%t/step.c
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t/k.c %t/step.c %t/sum.c 2>&1 | FileCheck %s --check-prefix=VERIFY
// CHECK: input[0]*input[0]
// STEP: "kernel":"step"
// VERIFY: value_return {{ *}}1 {{ *}}0 {{ *}}0
// A float in a function that is no template is no number of a kernel.
// RUN: not %symreal generate %s -o %t.c -- -DPLAIN 2>&1 | FileCheck %s --check-prefix=PLAIN
// PLAIN: error: 'x' holds no double: it is float [SYM026]
#include <vector>

#pragma symreal function input(x) range(-4, 4) output(return)
template <class T> T k(T x) {
  if (x < 0) return -x;
  T const y = x * x;
  return y + T(0.5);
}

template <class T> struct filter {
  T gain, last;
#pragma symreal function input(gain, last, x) range(-4, 4) output(last, return)
  T step(T x) { return last = gain * x + last; }
};

template <class T>
#pragma symreal function input(v[0:3]) range(-4, 4) output(w[0:3])
void sum(T const *v, T *w) {
  for (int i = 0; i < 3; ++i) w[i] = v[i] * v[0];
}

#ifdef PLAIN
#pragma symreal function input(x) output(return)
double plain(float x) { return x; }
#endif

template <class T> T all() {
  filter<T> one = {T(2), T(1)};
  T const v[3] = {1, 2, 3};
  T w[3];
  sum(v, w);
  return k(T(0.25)) + k(T(-1)) + one.step(T(0.5)) + w[2];
}

int main() {
#ifdef PLAIN
  if (plain(1) > 2) return 1;
#endif
  return all<float>() > 100 || all<double>() > 100;
}
