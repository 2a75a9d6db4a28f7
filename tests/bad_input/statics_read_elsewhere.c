/* A static integer of a function is scratch by itself only where neither another call of the function nor code to which its
   address goes, reads what the kernel leaves.
   RUN: rm -rf %t && not %symreal generate %s -o %t/ 2>&1 | FileCheck %s
   RUN: not ls %t
   A static that is written before it is read, element by element, by a function that is given it or in a loop, needs no clause.
   RUN: %symreal generate %s -o %t.c -- -DOWN && %symreal verify %s %t.c --samples=50 -- -DOWN
*/
#include <stdio.h>

#ifdef OWN
static void fill(int *list, int count)
{
  int k;
  for (k = 0; k < count; ++k) list[k] = k + 1;
}
static int sum(int count)
{
  static int list[3], total, k, first;
  static struct {
    int first, last;
  } ends;
  fill(list, 3);
  for (k = 0; k < count; ++k) total = list[k];
  fill(&first, 1);
  ends.last = list[2];
  return total + first + ends.last;
}
#pragma symreal function input(x) output(return)
double own(double x) { return x * sum(3); }
int main(void) { return printf("%g\n", own(0.5)) < 0; }

#else
/* CHECK-DAG: statics_read_elsewhere.c:[[@LINE+3]]:14: error: the kernel writes 'mode', which is not an output [SYM053]
*/
static int last(int wanted) {
  static int mode;
  if (wanted) mode = wanted;
  return mode;
}
#pragma symreal function input(x) output(return)
double setter(double x)
{
  last(7);
  return 2 * x;
}
/* CHECK-DAG: statics_read_elsewhere.c:[[@LINE+4]]:14: error: the kernel writes 'count', which is not an output [SYM053]
*/
static int *counter(void)
{
  static int count;
  return &count;
}
#pragma symreal function input(x) output(return)
double address(double x)
{
  *counter() = 7;
  return 2 * x;
}
int main(void) { return printf("%g %d %d\n", setter(0.5) + address(0.5), last(0), *counter()) < 0; }
#endif
