/* The same for what a kernel reads.
   RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
*/
double gain = 2, offset = 1;
int order = 3;

#pragma symreal function input(x) output(return)
double f(double x) { return gain * x + offset * order; }

int main(void)
{
    gain = 4;
    order = 5;
    offset = 6;
    return f(1) == 0;
}

/* CHECK-COUNT-2: [SYM017]
   CHECK-NOT: note: all of them
   CHECK: [SYM017]
   CHECK: finished_clause_frozen.c:7:1: note: all of them at once: #pragma symreal function ... constant(gain, offset, order), if they may be kept
*/
