/* A static integer of a function that the recorded path writes before it reads it is no scratch where a guard stands:
   beyond the guard the original reads what the calls before have left.
   RUN: not %symreal generate %s -o %t/ --decisions=guard 2>&1 | FileCheck %s
   RUN: not ls %t
   Where every path writes it first, it is.
   RUN: %symreal generate %s -o %t.c --decisions=guard -- -DFIRST && %symreal verify %s %t.c --samples=100 --min-samples=50 -- -DFIRST
   Where it is said to be scratch, verify sees that it is not.
   RUN: %symreal generate %s -o %t.c --decisions=guard -- -DLATER && not %symreal verify %s %t.c --samples=100 -- -DLATER 2>&1 | FileCheck %s --check-prefix=LATER
   LATER: error: where a guard fails, 1 of 1 outputs of the original depend on the calls before: it keeps something that the generated code does not [SYM091]
*/

/* CHECK-DAG: error: the kernel writes 'seen', which is not an output [SYM053]
*/
#ifdef LATER
#pragma symreal function input(x, u) scratch(file) output(return)
#else
#pragma symreal function input(x, u) output(return)
#endif
double branch(double x, double u)
{
  static int seen;
#ifdef FIRST
  seen = 1;
#endif
  if (x > 0) seen = 3;
  return seen * u;
}

#if !defined(FIRST) && !defined(LATER)
/* CHECK-DAG: error: the kernel writes 'list', which is not an output [SYM053]
*/
#pragma symreal function input(x, u) output(return)
double element(double x, double u)
{
  static int list[2];
  if (x > 0) list[1] = 3;
  return list[1] * u;
}
/* CHECK-DAG: error: the kernel writes 'phase', which is not an output [SYM053]
*/
#pragma symreal function input(x, u) output(return)
double machine(double x, double u)
{
  static enum { idle, busy } phase;
  switch (x > 0) {
  case 1: phase = busy; break;
  default: break;
  }
  return phase == busy ? u : -u;
}
/* Each path writes a part of this, which likely is what it reads; the recorded path decides, and a guard stands.
   CHECK-DAG: error: the kernel writes 'both', which is not an output [SYM053]
*/
#pragma symreal function input(x, u) output(return)
double parts(double x, double u)
{
  static int both[2];
  if (x > 0)
    both[0] = 3;
  else
    both[1] = 1;
  return both[0] * u;
}
/* So with a loop that likely runs.
   CHECK-DAG: error: the kernel writes 'count', which is not an output [SYM053]
*/
#pragma symreal function input(x, u) output(return)
double loop(double x, double u)
{
  static int count;
  double at;
  for (at = 0; at < x; at += 1) count = 3;
  return count * u;
}
#else
#define parts(x, u) 0
#define loop(x, u) 0
#define element(x, u) 0
#define machine(x, u) 0
#endif

int main(void) { return branch(1.5, 2) + element(1.5, 2) + machine(1.5, 2) + parts(1.5, 2) + loop(1.5, 2) > 9; }
