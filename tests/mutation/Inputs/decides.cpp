#include <cstdio>
#include <string>

static std::string mode = "slow";

#pragma symreal function input(x) output(return)
double scaled(double x) { return mode == "fast" ? 3 * x : 2 * x; }

int main() {
  std::printf("%g\n", scaled(0.5));
  mode = "fast";
  std::printf("%g\n", scaled(0.5));
}
