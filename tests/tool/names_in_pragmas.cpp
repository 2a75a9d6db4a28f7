// The words of a pragma become names, comments and strings of the generated code: as data, never as code.
// RUN: rm -rf %t && mkdir -p "%t/run/y $(touch evil) *"
// RUN: cd %t/run && %symreal generate %s --frozen=allow --decisions=guard --debug=comments --mainline 2> %t/messages
// RUN: cd %t/run && ls -R | FileCheck %s --check-prefix=FILES
// RUN: cd %t/run && %cc -std=c99 -Wall -Wextra -pedantic -Werror -Dmain=other_main -c "y $(touch evil) */ x.c" "y $(touch evil) */ x_main.c"
// RUN: cd %t/run && %symreal verify %s "y $(touch evil) */ x.c" --samples=50 --min-samples=1
// RUN: test ! -e %t/run/evil && test ! -e %t/evil
// FILES-NOT: evil{{$}}
// FILES: ./y $(touch evil) *:
// FILES-NEXT: x.c
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

int main() {
  std::map<std::string, double> m;
  m["*/ int evil; /*"] = 0.5;
  m["\"; system(\"touch evil\"); \\"] = 1.0;
  m["??/\n%n%s`touch evil`"] = 2.0;
  double z;
#pragma symreal input(m["*/ int evil; /*"], m["\"; system(\"touch evil\"); \\"], m["??/\n%n%s`touch evil`"])
  z = m["*/ int evil; /*"] > 0 ? std::sin(m["\"; system(\"touch evil\"); \\"]) : m["??/\n%n%s`touch evil`"];
#pragma symreal output(z) generate("y $(touch evil) */ x.c")
  std::printf("%g\n", z);
}
