#include <cstdio>
struct Sample {
  double value;
  char kind;
};
struct Marked : Sample {
  char mark;
};
#pragma symreal function input(x) output(return)
double kernel(double x) { return x * sizeof(Marked); }
int main() { std::printf("%g\n", kernel(5.3)); }
