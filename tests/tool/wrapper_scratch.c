/* Where a guard does not hold the wrapper calls the original, which finds its statics as generated code leaves them: generate refuses one that it may read.
   RUN: rm -rf %t && mkdir %t && cd %t && not %symreal generate %s -o k.c --wrapper --decisions=guard 2>&1 | FileCheck %s
   CHECK: error: the kernel writes 'last', which is not an output [SYM053]
   RUN: ls %t | count 0
*/
#pragma symreal function input(x, u) output(return)
double kern(double x, double u)
{
    static int last;
    if (x > 0) last = 3;
    return last * u;
}

int main(void) { return kern(1.5, 2) > 9; }
