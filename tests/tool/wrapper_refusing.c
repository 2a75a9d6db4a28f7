/* Where nothing else than the generated code is there, a call with another value than the recorded one ends the program.
   RUN: rm -rf %t && mkdir %t && cd %t && %symreal generate %s -o k.c --wrapper
   RUN: cd %t && %cc -std=c99 -Wall -Wextra -pedantic -Werror -DMAIN %s k.c k_wrapper.c -lm -o swapped
   RUN: cd %t && ./swapped && not --crash ./swapped 4 2>&1 | FileCheck %s
   CHECK: n: this call has another value than the generated code

   Where the original is there, it is called.
   RUN: cd %t && %symreal generate %s -o g.c --wrapper --decisions=guard -- -DGUARDED
   RUN: cd %t && %cc -DGUARDED -DFUNCTION -Wno-unknown-pragmas -Dkern=fallback -c %s -o original.o && %cc -DMAIN %s g.c g_wrapper.c original.o -lm -o swapped
   RUN: cd %t && ./swapped && ./swapped 4
*/
double kern(double x, int n, double gain);

#ifndef MAIN
#pragma symreal function input(x) constant(n, gain) output(return)
double kern(double x, int n, double gain) {
  int k;
#ifdef GUARDED
  if (x < 0) return gain;
#endif
  for (k = 0; k < n; ++k) x = x * gain + k;
  return x;
}
#endif

#ifndef FUNCTION
int main(int argc, char **argv) {
  double const expected = argc > 1 ? 43 : 20;
  (void)argv;
  return kern(2, argc + 2, 2) != expected;
}
#endif
