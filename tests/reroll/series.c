/* The terms of a series are a body over tables of amplitudes and frequencies, whatever their signs.
   RUN: rm -rf %t && mkdir %t
   RUN: %symreal generate %s --reroll -o %t/series.c
   RUN: FileCheck %s --input-file=%t/series.c
   CHECK: static double const values_[[ROWS:[0-9]+]][
   CHECK-NOT: values_
   CHECK: for (int k = 0; k < [[ROWS]]; ++k) {
   CHECK-NEXT: row = values_[[ROWS]] + 3*k;
   CHECK-NEXT: sin(
   CHECK-NOT: for (
   CHECK: output[0] =
   RUN: %symreal verify %s %t/series.c --samples=100 2>&1 | FileCheck %s --check-prefix=SAME
   SAME: 100 samples, 100 within the premises
   SAME: value_return {{ *}}1 {{ *}}0 {{ *}}0{{$}}
*/
enum { terms = 80 };
static double amplitude[terms], frequency[terms], phase[terms];

#pragma symreal function input(t) constant(amplitude[0:80], frequency[0:80], phase[0:80]) output(return)
double sum(double t) {
  double sum = 0;
  for (int k = terms - 1; k >= 0; --k) sum += amplitude[k] * __builtin_sin(frequency[k] * t + phase[k]);
  return sum;
}

int main(void) {
  for (int k = 0; k < terms; ++k) {
    amplitude[k] = (k % 3 ? 1.5 : -2.5) / (k + 3);
    frequency[k] = 0.25 * k + 0.125;
    phase[k] = k % 7 < 3 ? 0.5 + k : -0.25 * k;
  }
  return sum(0.5) > 100;
}
