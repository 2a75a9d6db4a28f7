// How far the original and the generated code are from exact values: sums in another order, and a cancellation.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/fast.c --fp=fast --effort=0 --kernel quadratic --decisions=select
// RUN: %symreal verify %s %t/fast.c --exact 256 --tol 1e-6 --samples 200 --json > %t/whole.json 2> %t/told
// RUN: FileCheck %s --check-prefix=FAST --input-file=%t/told
// FAST: exact values, in 256 bits: {{[0-9]+}} samples{{$}}
// FAST-NEXT: error of the original, at most the code, at most nearer on: the original, the code
// FAST-NEXT: root {{ *[0-9.]+e-[01][0-9] *[0-9.]+e-[01][0-9] *[0-9]+, [0-9]+$}}
// FAST-NEXT: sum {{ *[0-9.]+e-1[56] *[0-9.]+e-1[56] *[0-9]+, [0-9]+$}}

// The figures against the same numbers, made by Python's decimal arithmetic.
// RUN: python3 %S/Inputs/exact_errors.py %t/whole.json

// Shards give the same figures, and a certificate has them.
// RUN: %symreal verify %s %t/fast.c --exact 256 --tol 1e-6 --samples 200 --json --shard 1/2 > %t/1.json
// RUN: %symreal verify %s %t/fast.c --exact 256 --tol 1e-6 --samples 200 --json --shard 2/2 > %t/2.json
// RUN: %tool verify --merge %t/2.json %t/1.json --json > %t/joined.json 2> %t/joined.told
// RUN: diff %t/told %t/joined.told
// RUN: python3 -c "import json; a, b = (json.load(open(f'%t/{n}.json')) for n in ('whole', 'joined')); assert a['errors'] == b['errors'] and all(one in b['named'] for one in a['named']), (a, b)"
// RUN: %symreal verify %s %t/fast.c --tol 1e-6 --samples 200 --json --shard 2/2 > %t/without.json
// RUN: not %tool verify --merge %t/1.json %t/without.json 2>&1 | FileCheck %s --check-prefix=OTHER
// OTHER: this file cannot be joined with those before it: it has other exact values [SYM109]
// RUN: %symreal verify %s %t/fast.c --exact 100 --tol 1e-6 --samples 200 --certificate %t/c.json && grep '"bits": 100' %t/c.json
// RUN: %symreal verify %s %t/fast.c --check %t/c.json 2>&1 | FileCheck %s --check-prefix=CHECK
// CHECK: exact values, in 100 bits
// CHECK: holds

// In mode finite both are the same numbers. A decision that falls otherwise, and what is no operation on real numbers.
// RUN: %symreal generate %s -o %t/finite.c --kernel quadratic --decisions=select && %symreal verify %s %t/finite.c --samples 200 --exact 256 2>&1 | FileCheck %s --check-prefix=FINITE
// FINITE: root {{.*}} 0, 0{{$}}
// RUN: %symreal generate %s -o %t/near.c --kernel near --decisions=select && %symreal verify %s %t/near.c --samples 200 --exact 256 2>&1 | FileCheck %s --check-prefix=NEAR
// NEAR: exact values, in 256 bits: {{[0-9]+}} samples; {{[0-9]+}} more, where a decision falls otherwise in them or a value is not finite
// RUN: %symreal generate %s -o %t/bits.c --kernel bits --decisions=select && %symreal verify %s %t/bits.c --samples 200 --exact 256 2>&1 | FileCheck %s --check-prefix=BITS
// BITS: exact values, in 256 bits: there are none: 'nextafter' is not an operation on real numbers

// What is no number of bits, and where the option says nothing.
// RUN: not %symreal verify %s %t/finite.c --exact 64 2>&1 | FileCheck %s --check-prefix=RANGE
// RANGE: error: --exact: {{.*}}64 not in range {{\[?}}65{{.*}}65536
// RUN: not %symreal verify %s %t/finite.c --exact 256 --check %t/c.json 2>&1 | FileCheck %s --check-prefix=OPTION
// OPTION: error: --exact has no effect with --check, which does what the certificate says [SYM010]
#include <cmath>

#pragma symreal function input(p) range(1, 2) input(q) range(0, 1e-6) output(root, sum)
void quadratic(double p, double q, double &root, double &sum) {
  root = std::sqrt(p * p + q) - p;
  sum = p / 3 + q / 3 + p / 7;
}

#pragma symreal function input(x) range(0, 1) output(y)
void near(double x, double &y) { y = x + 1e17 > 1e17 ? -x : x; }

#pragma symreal function input(x) range(0, 1) output(y)
void bits(double x, double &y) { y = std::nextafter(x, 2.0); }

int main() {
  double a, b, c, d;
  quadratic(1.5, 1e-7, a, b);
  near(0.5, c);
  bits(0.3, d);
  return !(a < 1 && b > 0 && c != 2 && d < 1);
}
