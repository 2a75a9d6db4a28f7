#include <cstdio>
#include <cstring>
#include <typeinfo>
template <class T> double sign(T x) { return std::strcmp(typeid(T).name(), "d") == 0 ? x : -x; }
#pragma symreal function input(x) output(return)
double kernel(double x) { return sign(x); }
int main() { std::printf("%g\n", kernel(5.3)); }
