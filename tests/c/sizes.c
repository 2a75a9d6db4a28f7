/* In C a truth value and a character are ints, and arrays become pointers in `,` and `?:`. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %cc %s -o %t.orig -lm && %symreal-cc %s -o %t.exe -lm && %t.orig > %t.plain && %t.exe | diff %t.plain -
// RUN: FileCheck %s --check-prefix=PRINTS < %t.plain
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

enum { letters = sizeof('a') };
// CHECK: static char table[sizeof(REAL_OF_C(int, 2 > 1))];
static char table[sizeof(2 > 1)];
struct record { char text[sizeof(!letters)]; };
struct flags { unsigned all : 32; unsigned long low : 20; };

double weighted(double x)
{
    struct flags flags = {1, 2};
    char name[10];
    int i = 3;
    // CHECK: x * sizeof(REAL_OF_C(int, 1 == 1)) + sizeof(REAL_OF_C(int, 'a')) * 10;
    double y = x * sizeof(1 == 1) + sizeof('a') * 10;
    // CHECK: y += sizeof REAL_OF_C(int, !i) * 100.0 + sizeof(REAL_OF_C(int, x > 1)) * 1e3 + sizeof(REAL_OF_C(int, i && i)) * 1e4;
    y += sizeof !i * 100.0 + sizeof(x > 1) * 1e3 + sizeof(i && i) * 1e4;
    // CHECK: y += sizeof(REAL_OF_C(char *, 0, name)) * 1e5 + sizeof(REAL_OF_C(int, i ? 'a' : 'b')) * 1e6 + sizeof(name) * 1e7;
    y += sizeof(0, name) * 1e5 + sizeof(i ? 'a' : 'b') * 1e6 + sizeof(name) * 1e7;
    // CHECK: y += sizeof(REAL_OF_C(int, isnan(x))) * 1e8 + sizeof(REAL_OF_C(int, true)) * 1e9 + sizeof(i == 2 ? 1.5 : 'a') * 1e10;
    y += sizeof(isnan(x)) * 1e8 + sizeof(true) * 1e9 + sizeof(i == 2 ? 1.5 : 'a') * 1e10;
    // CHECK: y += sizeof((unsigned int)(i ? flags.all : 1u)) * 1e11 + sizeof((int)(i ? (int)(flags.low) : (int)(flags.low))) * 1e12;
    y += sizeof(i ? flags.all : 1u) * 1e11 + sizeof(i ? flags.low : flags.low) * 1e12;
    // CHECK: y += sizeof(REAL_OF_C(int, i ? *name : *table)) * 1e13 + sizeof(i ? *name : i) * 1e14 + sizeof *name;
    y += sizeof(i ? *name : *table) * 1e13 + sizeof(i ? *name : i) * 1e14 + sizeof *name;
    {
        // CHECK: __typeof__(REAL_OF_C(int, i > 1)) count = 5;
        __typeof__(i > 1) count = 5;
        y += count * sizeof(struct record) * sizeof(table);
    }
    return y;
}

int main(void)
{
    double x = 3, y;
#pragma symreal input(x)
    y = weighted(x);
#pragma symreal output(y) generate("y.c")
    // PRINTS: 444484504844533{{$}}
    printf("%.17g\n", y);
    return 0;
}
