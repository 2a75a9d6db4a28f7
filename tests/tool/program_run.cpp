// Arguments, input and directory of the program; its output appears on standard error, prefixed.
// RUN: rm -rf %t && mkdir -p %t/here && echo 7 > %t/number && echo 5 > %t/here/data
// RUN: %symreal generate %s -o %t/a.c --run-args='"first word" second' --stdin=%t/number --cwd=%t/here --run-on 2>&1 \
// RUN:   | FileCheck %s
// CHECK: program| first word, second: 7 5
// CHECK: program| done
// RUN: %symreal generate %s -o %t/a.c --run-args='a b' --stdin=%t/number --cwd=%t/here 2>&1 | FileCheck %s --check-prefix=ENDED
// ENDED-NOT: program| done
#include <cstdio>

int main(int argc, char **argv) {
  int number = 0, data = 0;
  if (argc != 3 || std::scanf("%d", &number) != 1) return 1;
  std::FILE *file = std::fopen("data", "r");
  if (!file || std::fscanf(file, "%d", &data) != 1) return 2;
  std::printf("%s, %s: %d %d\n", argv[1], argv[2], number, data);
  double x = number, y;
#pragma symreal input(x)
  y = x * x;
#pragma symreal output(y) generate("y.c")
  std::printf("done\n");
}
