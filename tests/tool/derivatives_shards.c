/* Derivatives are verified in shards, whose records join to one that says what a single run says.
   RUN: rm -rf %t && mkdir %t
   RUN: %symreal generate %s -o %t/k.c --separate
   RUN: %symreal verify %s %t/k.c %t/k_derivatives.c --samples=120 --shard 1/3 --json > %t/1.json
   RUN: %symreal verify %s %t/k.c %t/k_derivatives.c --samples=120 --shard 2/3 --json > %t/2.json
   RUN: %symreal verify %s %t/k.c %t/k_derivatives.c --samples=120 --shard 3/3 --json > %t/3.json
   RUN: %symreal verify --merge %t/1.json %t/2.json %t/3.json --json 2> %t/merged.txt > %t/merged.json
   RUN: %symreal verify %s %t/k.c %t/k_derivatives.c --samples=120 --json 2> %t/whole.txt > %t/whole.json
   RUN: FileCheck %s --input-file=%t/merged.txt
   RUN: grep jacobian_y_x %t/whole.txt > %t/one.txt && grep jacobian_y_x %t/merged.txt | diff - %t/one.txt
   CHECK: jacobian_y_x{{.* 4 .* 0 +[0-9]+ of 120}}

   A wrong element of one shard is wrong in all.
   RUN: sed 's/(cos(/(1.001*cos(/' %t/k_derivatives.c > %t/wrong_derivatives.c && cp %t/k_derivatives.h %t/wrong_derivatives.h
   RUN: not %symreal verify %s %t/wrong_derivatives.c --samples=120 --shard 1/2 --json > %t/4.json
   RUN: not %symreal verify %s %t/wrong_derivatives.c --samples=120 --shard 2/2 --json > %t/5.json
   RUN: not %symreal verify --merge %t/4.json %t/5.json 2>&1 | FileCheck %s --check-prefix=WRONG
   WRONG: error: {{[0-9]+}} of 4 elements of derivatives differ from those of the original
   WRONG: jacobian_y_x[{{.*}} give {{.*}}, generated {{.*}}, inputs

   A record without derivatives is of another shape.
   RUN: /usr/bin/python3 -c "import json; d = json.load(open('%t/2.json')); del d['kernels'][1]['derivatives']; json.dump(d, open('%t/none.json', 'w'))"
   RUN: not %symreal verify --merge %t/1.json %t/none.json %t/3.json 2>&1 | FileCheck %s --check-prefix=SHAPE
   SHAPE: none.json: error: this file cannot be joined with those before it: its kernel has another shape [SYM109]
*/
#include <math.h>

#pragma symreal function input(x[0:2]) range(-1, 1) output(y[0:2]) jacobian(y, x)
void k(double const *x, double *y) {
  y[0] = sin(x[0] * 3.0) * x[1];
  y[1] = exp(x[1]) + x[0] * x[0];
}

int main(void) {
  double const x[2] = {0.5, 0.25};
  double y[2];
  k(x, y);
  return 0;
}
