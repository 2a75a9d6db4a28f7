// State that only an instantiation of a template names.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not="error:"
// RUN: %symreal generate %s -o %t.c --frozen=allow && %symreal verify %s %t.c --samples=50
// A static constant without a definition is none.
#include <cstdio>

template <class T> struct Limits {
  static T low;
  // CHECK-DAG: hidden_in_templates.cpp:[[#@LINE+1]]:29: error: kernel 'scaled' reads 'low' (2), which is neither input nor parameter [SYM017]
  static T first() { return low; }
  static const int count = 3;
};
template <class T> T Limits<T>::low = 2;
template <class T> T limit = 3;
// CHECK-DAG: hidden_in_templates.cpp:[[#@LINE+1]]:40: error: kernel 'scaled' reads 'Limits<T>::low' (2), which is neither input nor parameter [SYM017]
template <class T> T low_of() { return Limits<T>::low; }
// CHECK-DAG: hidden_in_templates.cpp:[[#@LINE+1]]:42: error: kernel 'scaled' reads 'limit<T>' (3, 3), which are neither input nor parameter [SYM017]
template <class T> T limit_of() { return limit<T>; }
template <class T> T &slot() {
  static T value = 4;
  return value;
}
// CHECK-DAG: hidden_in_templates.cpp:[[#@LINE+1]]:54: error: kernel 'scaled' reads 'slot<T>()' (4), which is neither input nor parameter [SYM017]
template <class T> double of_slot(double x) { return slot<T>() * x; }
// CHECK-DAG: hidden_in_templates.cpp:[[#@LINE+1]]:66: error: kernel 'scaled' reads 'gain' (5), which is neither input nor parameter [SYM017]
template <float &gain> double of_argument(double x) { return x * gain; }
float gain = 5;
struct Mode {
  static bool on;
  static int steps;
};
bool Mode::on = true;
int Mode::steps = 2;
template <class M> double of_mode(double x) {
  // CHECK-DAG: hidden_in_templates.cpp:[[#@LINE+1]]:14: error: kernel 'scaled' reads 'M::on' (1), which is neither input nor parameter [SYM017]
  double y = M::on ? x : -x;
  // CHECK-DAG: hidden_in_templates.cpp:[[#@LINE+1]]:23: error: kernel 'scaled' reads 'M::steps' (2), which is neither input nor parameter [SYM017]
  for (int k = 0; k < M::steps; ++k) y *= x;
  return y + Limits<M>::count;
}

void change() {
  Limits<double>::low = Limits<int>::low = limit<double> = limit<long> = slot<float>() = gain = 7;
  Mode::on = false, Mode::steps = 3;
}

#pragma symreal function input(x) output(return)
double scaled(double x) {
  return low_of<double>() * x + limit_of<double>() + Limits<int>::first() + limit_of<long>() + of_slot<float>(x) +
         of_argument<gain>(x) + of_mode<Mode>(x);
}

int main(int count, char **) {
  if (count > 5) change();
  std::printf("%g\n", scaled(0.5));
}
