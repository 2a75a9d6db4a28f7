/* What is asked for in many diagnostics stands behind the last of them, ready to be pasted.
   RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
   RUN: sed 's/ output(return)$/ output(return) constant(count, gain, order) scratch(count, work)/' %s > %t.pasted.c
   RUN: %symreal generate %t.pasted.c -o %t.2.c
*/
static double work[2];
static int count;
double gain = 2;
int order = 3;

#pragma symreal function input(x) output(return)
double f(double x)
{
    count++;
    work[0] = gain * x;
    work[1] = order;
    return work[0] + work[1];
}

int main(void)
{
    gain = 4;
    order = 5;
    return f(1) == 0;
}

/* CHECK: the kernel writes 'work', which is not an output [SYM053]
   CHECK: finished_clause.c:11:1: note: all of them at once: #pragma symreal function ... constant(count, gain, order) scratch(count, work)
   CHECK-NOT: note: all of them
*/
