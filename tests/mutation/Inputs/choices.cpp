#include <cstdio>
struct One {
  char c;
};
struct Two {
  char c[2];
};
template <class T> One test(int T::*);
template <class T> Two test(...);
template <class T> double detected(T x) { return sizeof(test<T>(0)) == 1 ? -x : x; }
#pragma symreal function input(x) output(return)
double kernel(double x) { return detected(x); }
int main() { std::printf("%g\n", kernel(0.7)); }
