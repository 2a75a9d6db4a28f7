// What locates an output is read again at the return.
// RUN: not %rewrite %s 2>&1 | FileCheck %s
// CHECK: changed_output.c:[[@LINE+3]]:48: error: 'out[0:n]' is read when the function returns, but 'out' changes [SYM026]
// CHECK: changed_output.c:[[@LINE+4]]:{{[0-9]+}}: note: it is changed here
// CHECK: changed_output.c:[[@LINE+1]]:48: error: 'out[0:n]' is read when the function returns, but 'n' changes [SYM026]
#pragma symreal function input(in[0:n]) output(out[0:n])
void copy(double *out, const double *in, int n) {
  while (n--) *out++ = *in++;
}
