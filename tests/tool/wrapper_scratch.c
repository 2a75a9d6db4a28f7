/* Where a guard does not hold the wrapper calls the original, which finds its statics as generated code leaves them.
   RUN: rm -rf %t && mkdir %t && cd %t && not %symreal generate %s -o k.c --wrapper --decisions=guard 2>&1 | FileCheck %s
   CHECK: error: --wrapper cannot take the place of 'kern': where a guard does not hold the original is called, and may read 'last', which generated code does not write [SYM095]
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
