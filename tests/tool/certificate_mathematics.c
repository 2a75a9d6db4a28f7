// A certificate names the mathematical library, with the code that it has chosen by the processor; a check with other code says so.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/k.c
// RUN: %symreal verify %s %t/k.c --samples=50 --certificate %t/c.json
// RUN: FileCheck %s --input-file=%t/c.json
// CHECK: "mathematics": "{{.*}}, code {{.*}} ({{[0-9a-f]+}})"
// RUN: %symreal verify %s %t/k.c --check %t/c.json 2>&1 | FileCheck %s --check-prefix=SAME
// SAME-NOT: the certificate was written with
// SAME: holds
// Where there are two kinds, the other one:
// RUN: ! grep -qw fma /proc/cpuinfo || env GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-AVX2_Usable,-FMA_Usable %symreal verify %s %t/k.c --check %t/c.json > %t/other.txt 2>&1
// RUN: ! grep -qw fma /proc/cpuinfo || grep 'the certificate was written with .*code for processors with FMA .*; these functions are those of .*code for processors without FMA ' %t/other.txt

#pragma symreal function input(x[0:2]) range(-2, 2) output(y[0:1])
void k(double const *x, double *y) { y[0] = x[0] * x[1] + x[0]; }

int main(void) {
  double x[2] = {0.5, 1.25}, y[1];
  k(x, y);
  return 0;
}
