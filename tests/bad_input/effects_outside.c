/* A kernel that changes the environment, a file or a position in one has an effect that generated code does not have.
   RUN: not %symreal generate %s -o %t/ 2>&1 | FileCheck %s
   RUN: not ls %t
   Text on the standard output is left out. verify says so, and sees by itself what lasts.
   RUN: %symreal generate %s -o %t.c -- -DPRINTS 2>&1 | FileCheck %s --check-prefix=NOTHING --allow-empty --implicit-check-not="[SYM"
   RUN: %symreal verify %s %t.c --samples=50 -- -DPRINTS 2>&1 | FileCheck %s --check-prefix=PRINTS
   RUN: %symreal generate %s -o %t.c -- -DLATER && not %symreal verify %s %t.c --samples=50 -- -DLATER 2>&1 | FileCheck %s --check-prefix=LATER
   RUN: not %symreal generate %s -o %t.c -- -DPOSITION 2>&1 | FileCheck %s --check-prefix=POSITION
   POSITION: error: kernel 'told' reads 'ftell()' (0)
   Results from outside of the program that the recording has not noted are seen by verify as well; those that it has are allowed.
   RUN: %symreal generate %s -o %t.c -- -DPOSITION_LATER && not %symreal verify %s %t.c --samples=50 -- -DPOSITION_LATER 2>&1 | FileCheck %s --check-prefix=UNNOTED
   UNNOTED: error: kernel 'told': the original reads 'ftell()', and the generated code does not [SYM215]
   RUN: %symreal generate %s -o %t.c -- -DCONVENTION && not %symreal verify %s %t.c --samples=50 -- -DCONVENTION 2>&1 | FileCheck %s --check-prefix=CONVENTION
   CONVENTION: error: kernel 'written': the original reads 'localeconv()', and the generated code does not [SYM215]
   RUN: %symreal generate %s -o %t.c --frozen=allow -- -DPOSITION && %symreal verify %s %t.c --samples=50 -- -DPOSITION
   NOTHING: kernel
   PRINTS: outside of the program: the original writes to standard output, and the generated code does not
   LATER: error: kernel 'set': the original changes the environment variable 'SEEN', and the generated code does not [SYM215]
*/
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

#ifdef PRINTS
#pragma symreal function input(x) output(return)
double shown(double x)
{
  printf("here\n");
  return 2 * x;
}
int main(void) { return shown(0.5) > 5; }

#elif defined(POSITION)
static FILE *file;
#pragma symreal function input(x) output(return)
double told(double x) { return x * (double)ftell(file); }
int main(void)
{
  file = tmpfile();
  return told(0.5) > 5;
}

#elif defined(POSITION_LATER)
static FILE *file;
#pragma symreal function input(x) output(return)
double told(double x)
{
  double y = 2 * x;
#ifndef MBD_SYMBOLIC
  y += (double)ftell(file);
#endif
  return y;
}
int main(void)
{
  file = tmpfile();
  return told(0.5) > 5;
}

#elif defined(CONVENTION)
#include <locale.h>
#pragma symreal function input(x) output(return)
double written(double x)
{
  double y = 2 * x;
#ifndef MBD_SYMBOLIC
  if (localeconv()->decimal_point[0] == ',') y += 1;
#endif
  return y;
}
int main(void) { return written(0.5) > 5; }

#elif defined(LATER)
#pragma symreal function input(x) output(return)
double set(double x)
{
#ifndef MBD_SYMBOLIC
  setenv("SEEN", "1", 1);
#endif
  return 2 * x;
}
int main(void) { return set(0.5) > 5; }

#else
static FILE *file;

/* CHECK-DAG: effects_outside.c:[[@LINE+2]]:1: error: the kernel changes the environment variable 'SEEN', and the generated code would not do so [SYM215]
*/
#pragma symreal function input(x) output(return)
double set(double x)
{
  setenv("SEEN", "1", 1);
  return 2 * x;
}
/* CHECK-DAG: effects_outside.c:[[@LINE+2]]:1: error: the kernel writes to {{.*}}, and the generated code would not do so [SYM215]
*/
#pragma symreal function input(x) output(return)
double logged(double x)
{
  fputc('x', file);
  return 2 * x;
}
/* CHECK-DAG: effects_outside.c:[[@LINE+2]]:1: error: the kernel changes the mask of permissions, and the generated code would not do so [SYM215]
*/
#pragma symreal function input(x) output(return)
double masked(double x)
{
  umask(022);
  return 2 * x;
}

int main(void)
{
  file = tmpfile();
  return set(0.5) + logged(0.5) + masked(0.5) > 5;
}
#endif
