/* What the recorded path rests on is asked when the loops are done, before a result is stored.
   RUN: rm -rf %t && mkdir %t
   RUN: %symreal generate %s --reroll --decisions=guard -o %t/g.c
   RUN: FileCheck %s --input-file=%t/g.c
   CHECK: int compute(
   CHECK: compute_{{[0-9]+}}(input, v);
   CHECK: if (v[{{[0-9]+}}] == 0.0) return 1;
   CHECK: compute_{{[0-9]+}}(v, output);
   CHECK: return 0;
   RUN: %symreal verify --samples=100 --min-samples=10 %s %t/g.c 2>&1 | FileCheck %s --check-prefix=SAME
   SAME: refused by a guard: {{[1-9]}}
   SAME: value_return {{ *}}1 {{ *}}0 {{ *}}0{{$}}
*/
#pragma symreal function input(x[0:60]) output(return)
double sum(double const *x) {
  double sum = 0;
  for (int k = 0; k < 60; ++k) sum = 0.5 * sum + x[k];
  return sum > 1 ? 2 * sum : sum * sum;
}

int main(void) {
  double x[60];
  for (int k = 0; k < 60; ++k) x[k] = 1.5;
  return sum(x) > 100;
}
