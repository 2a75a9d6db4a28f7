/* Integers of 64 bits are no doubles: products, hashes and random numbers are computed in all their bits. */
// RUN: rm -rf %t && mkdir %t
// RUN: %same %s
// RUN: %symreal generate %s --decisions=select --mainline -o %t/k.c && FileCheck %s --input-file=%t/k.c
// RUN: %symreal verify %s %t/k.c --samples=500
// RUN: %symreal generate %s --decisions=select --fp=strict -o %t/s.c && %symreal verify %s %t/s.c --samples=500
// RUN: %cc -w %s -o %t/original -lm && %symreal-cc -w %s -o %t/symbolic -lm && env SYMREAL_REQUEST=decisions=select %t/symbolic | tail -n 10 > %t/printed
// RUN: %t/original 0.3 0.7 > %t/expected && diff %t/expected %t/printed
// RUN: %cc -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror %t/k.c %t/k_main.c -lm -o %t/run
// RUN: %t/run 0.3 0.7 | diff %t/expected -
// RUN: %t/original -11.9 8.25 > %t/expected && %t/run -11.9 8.25 | diff %t/expected -
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* CHECK: #include <stdint.h>
   CHECK-DAG: uint64_t const t{{[0-9]+}} =
   CHECK-DAG: UINT64_C(6364136223846793005)
*/
#pragma symreal function input(x[0:2]) range(-20, 20) output(y[0:10])
void k(double const *x, double *y)
{
    long l = (long)(x[0] * 1e8), m = (long)(x[1] * 1e8);
    y[0] = (double)(l * m - (l * m - 1));
    y[1] = (double)((l * 3 + 1) % 3);
    unsigned long v = (unsigned long)(x[1] * x[1]);
    y[2] = (double)(v - 5);
    uint32_t u = (uint32_t)(x[0] * x[0] * 100);
    u = u * 1664525u + 1013904223u;
    u = u * 1664525u + 1013904223u;
    y[3] = u;
    uint64_t h = (uint64_t)(x[1] * x[1] * 1000);
    h = h * 6364136223846793005ULL + 1442695040888963407ULL;
    y[4] = (double)(h >> 33);
    h ^= h >> 29;
    y[5] = (double)(h & 0xFFFF) + (double)(uint32_t)h;
    int64_t q = l * 1000000007LL;
    y[6] = (double)(q / 1009 + q % 1009);
    y[7] = q < l * 1000000006LL ? 1.5 : 2.5;
    y[8] = (double)(int)(q >> 3);
    y[9] = (double)(h / 10 % 97);
}

int main(int count, char **arguments)
{
    double x[2] = {0.3, 0.7}, y[10] = {0};
    int i;
    for (i = 1; i < count; i++) x[i - 1] = atof(arguments[i]);
    k(x, y);
    for (i = 0; i < 10; i++) printf("y[%d] = %.17g\n", i, y[i]);
    return 0;
}
