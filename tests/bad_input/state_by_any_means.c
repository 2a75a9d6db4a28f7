/* State that is read or written by assembly, atomic operations, checked arithmetic, functions of the C library, and by
   copies of unions and of the library's structures. What clauses name, and what is local, may be read and written so.
   RUN: rm -rf %t && mkdir %t
   RUN: not %symreal generate %s -o %t/ -- -DREADS 2>&1 | FileCheck %s --implicit-check-not="error:"
   RUN: not %symreal generate %s -o %t/ -- -DWRITES 2>&1 | FileCheck %s --check-prefix=WRITTEN --implicit-check-not="error:"
   RUN: ls %t | count 0
   RUN: cd %t && %symreal generate %s -o ./
   RUN: cd %t && %symreal verify %s reads.c writes.c local_reads.c local_writes.c --samples=50
*/
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

union word { int i; float f; };

// CHECK-DAG: error: kernel 'reads' reads 'order' (2), which is neither input nor parameter [SYM017]
static int order = 2;
// CHECK-DAG: error: kernel 'reads' reads 'moved' (1), which is neither input nor parameter [SYM017]
static int moved = 1;
// CHECK-DAG: error: kernel 'reads' reads 'begun', which is neither input nor parameter [SYM017]
static struct tm begun;
// CHECK-DAG: error: kernel 'reads' reads 'shares', which is neither input nor parameter [SYM017]
static div_t shares = {7, 1};
// CHECK-DAG: error: kernel 'reads' reads 'word', which is neither input nor parameter [SYM017]
static union word word = {4};

void change(int to) { order = moved = begun.tm_sec = shares.quot = word.i = to; }

#ifdef READS
#pragma symreal function input(x) output(return)
#else
#pragma symreal function input(x) constant(order, moved, begun, shares, word) output(return)
#endif
double reads(double x)
{
    int found = moved;
    union word mine;
    struct tm now = begun;
    div_t share = shares;
    mine = word;
#ifdef __x86_64__
    __asm__("movl %1, %0" : "=r"(found) : "m"(moved));
#endif
    return x * (found * __atomic_load_n(&order, __ATOMIC_RELAXED) + now.tm_sec + share.quot + mine.i);
}

#pragma symreal function input(x) output(return)
double local_reads(double x)
{
    int order = 2, moved = 1, found = moved;
    struct tm begun = {0}, now = begun;
    div_t shares = {7, 1}, share = shares;
    union word word = {4}, mine;
    mine = word;
#ifdef __x86_64__
    __asm__("movl %1, %0" : "=r"(found) : "m"(moved));
#endif
    return x * (found * __atomic_load_n(&order, __ATOMIC_RELAXED) + now.tm_sec + share.quot + mine.i);
}

static int summed = 0, stored = 3, last = 7;
static char copied[8] = "ab", joined[8] = "ab", *rest;
static struct tm ended;
static div_t halves = {3, 1};
static union word other = {5};

int found(void) { return summed + stored + last + copied[0] + joined[0] + *rest + ended.tm_sec + halves.quot + other.i; }

#ifdef WRITES
#pragma symreal function input(x) output(return)
#else
#pragma symreal function input(x) scratch(summed, stored, last, copied, joined, rest, ended, halves, other) output(return)
#endif
double writes(double x)
{
    // WRITTEN-DAG: error: the kernel writes 'summed', which is not an output [SYM053]
    (void)__builtin_add_overflow(0, 0, &summed);
    // WRITTEN-DAG: error: the kernel writes 'stored', which is not an output [SYM053]
    __atomic_store_n(&stored, 3, __ATOMIC_RELAXED);
    // WRITTEN-DAG: error: the kernel writes 'last', which is not an output [SYM053]
#ifdef __x86_64__
    __asm__("movl $7, %0" : "=m"(last));
#else
    last = 7;
#endif
    // WRITTEN-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: the kernel writes 'copied', which is not an output [SYM053]
    memccpy(copied, "ab", 0, 3);
    // WRITTEN-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: the kernel writes 'joined', which is not an output [SYM053]
    mempcpy(joined, "ab", 3);
    // WRITTEN-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: the kernel writes '&rest', which is not an output [SYM053]
    x += strtod("2", &rest);
    // WRITTEN-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: the kernel writes 'ended', which is not an output [SYM053]
    ended = (struct tm){0};
    // WRITTEN-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: the kernel writes 'halves', which is not an output [SYM053]
    halves = div(7, 2);
    // WRITTEN-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: the kernel writes 'other', which is not an output [SYM053]
    other = (union word){5};
    return x;
}

#pragma symreal function input(x) output(return)
double local_writes(double x)
{
    int summed = 0, stored = 3, last = 7;
    char copied[8] = "ab", joined[8] = "ab", *rest;
    struct tm ended;
    div_t halves = {3, 1};
    union word other = {5};
    (void)__builtin_add_overflow(0, 0, &summed);
    __atomic_store_n(&stored, 3, __ATOMIC_RELAXED);
#ifdef __x86_64__
    __asm__("movl $7, %0" : "=m"(last));
#else
    last = 7;
#endif
    memccpy(copied, "ab", 0, 3);
    mempcpy(joined, "ab", 3);
    x += strtod("2", &rest);
    ended = (struct tm){0};
    halves = div(7, 2);
    other = (union word){5};
    return x;
}

int main(void)
{
    printf("%g %g %g %g\n", reads(0.5), local_reads(0.5), writes(0.5), local_writes(0.5));
    return 0;
}
