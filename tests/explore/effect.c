/* The paths stand side by side in the generated code, so a function with an effect cannot be called on one of them.
   RUN: rm -rf %t && mkdir %t && cd %t
   RUN: printf '#include <stdio.h>\ndouble count(double x) { return puts("called") + x; }\n' > library.c
   RUN: %cc -c library.c -o library.o && ar rcs liblibrary.a library.o && cp %s main.c
   RUN: not %symreal generate main.c -o f.c --decisions=explore --link "-L%t -llibrary" 2>&1 | FileCheck %s
   RUN: not ls f.c
   CHECK: error: the kernel decides on values and calls 'count', which has an effect [SYM191]
   Without effects it may be called. Each path calls its own.
   RUN: sed 's/external(count)/external(count) pure/' %s > main.c
   RUN: %symreal generate main.c -o f.c --decisions=explore --link "-L%t -llibrary" 2>&1 | FileCheck %s --check-prefix=PURE
   PURE: explored 3 paths, 2 selects between them; complete: no guards
   RUN: %symreal verify main.c f.c --samples=100 --link "-L%t -llibrary" 2>&1 | FileCheck %s --check-prefix=SAME
   SAME: no sample is left to a guard
   SAME: value_return 1 0 0{{$}}
   */
#include <stdio.h>
double count(double x);
#pragma symreal external(count)
#pragma symreal function input(x) output(return)
double f(double x) {
  if (x > 1) return count(x);
  return x < 0 ? count(-x) : x;
}
int main(void) {
  printf("%g\n", f(0.5));
  return 0;
}
