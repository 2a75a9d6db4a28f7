// A template that converts an enumerator to a number by itself: what it returns, stores, computes with, or folds.
// RUN: %symreal generate %s -o %t.c --decisions=auto -- -std=c++17 && FileCheck %s < %t.c
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c -- -std=c++17 2>&1 | FileCheck %s --check-prefix=VERIFY
// CHECK: input[0]
// VERIFY: value_return {{ *}}1 {{ *}}0 {{ *}}0
enum shade { dark = 1, light = 3, bright = 7 };
enum class tone { low = 2, high = 5 };
enum large : unsigned long { least = 1, most = 0xFFFFFFFFFFFFFFFF };

template <class... T> double sum(T... t) { return (t + ...); }
template <class... T> double quotient(T... t) { return (t / ...); } // of integers, where there are two
template <class... T> double shades(T... t) { return (static_cast<shade>(t) + ...); }
template <class... T> double numbers(T... t) { return (static_cast<double>(t) + ...); }
template <class T> double one(T t) { return t; }
template <class T> double chosen(T t, T u) { return u == t ? t : u; }
template <class T, class U> double divided(T t, U u) { return t / u; }
template <class T> double least_of(double x, T t) { return x < t ? x : t; }
template <class T> double stored(T t) {
  double to = t, list[2];
  to += t;
  list[0] = list[1] = t;
  return to * t - list[0] - list[1] * (-t);
}

#pragma symreal function input(x) range(-4, 4) output(return)
double k(double x) {
  double const folded = sum(dark) + sum(dark, light) + quotient(bright) + quotient(bright, light) + sum(most);
  double const scoped = shades(tone::low) + shades(tone::low, tone::high) + numbers(tone::high) + numbers(dark, light);
  double const beside = divided(bright, 2.0) + divided(bright, light) + divided(x, light) + divided(7, light);
  return x * (folded + scoped + beside) + least_of(x, light) + least_of(x, 2.5) + stored(light) + stored(x) + one(dark) +
         chosen(dark, light) + chosen(x, 1.5);
}

int main() { return k(0.3) > 1e30; }
