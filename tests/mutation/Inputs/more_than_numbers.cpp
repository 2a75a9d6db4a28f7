#include <cstdio>
struct Judged {
  double value;
  int status;
};
#pragma symreal function input(x) output(return)
Judged kernel(double x) {
  Judged result;
  result.value = 2 * x;
  result.status = 1;
  return result;
}
int main() { std::printf("%g\n", kernel(0.7).value); }
