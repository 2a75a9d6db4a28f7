// What a macro names by `...` is one argument here and several there.
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s
// CHECK: y {{ *}}1 {{ *}}0 {{ *}}0
#include <cstdio>
#include <cstdlib>

struct Part {
  double mass;
  int joint;
};
#define JOINT(p) (p)->joint
#define PRINT(...)                                                                                                     \
  do {                                                                                                                 \
    std::fprintf(stderr, "%s:%d: ", "file", 1);                                                                        \
    std::fprintf(stderr, __VA_ARGS__);                                                                                 \
  } while (0)
#define WARN(...) PRINT(__VA_ARGS__)

double f(Part const *parts, double q) {
  if (parts[0].joint > 3) WARN("joint %d\n", JOINT(parts) + 1);
  if (parts[1].joint > 3) WARN("joints %d %d\n", JOINT(parts), JOINT(parts + 1));
  if (parts[1].joint > 4) WARN("no joint\n");
  return parts[0].mass * q + parts[1].joint;
}

int main() {
  static Part const parts[] = {{1.5, 2}, {2.5, 1}};
  double q = 0.5, y;
#pragma symreal input(q)
  y = f(parts, q);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
