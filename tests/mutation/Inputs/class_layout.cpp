#include <cstdio>
template <class T> struct Node {
  T value;
  int next;
};
struct Leaf : Node<double> {
  int weight;
};
#pragma symreal function input(x) output(return)
double kernel(double x) { return x * sizeof(Leaf); }
int main() { std::printf("%g\n", kernel(5.3)); }
