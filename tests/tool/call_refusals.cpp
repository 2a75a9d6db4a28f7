// --kernel: state that a method changes, ranges without samples, and what is named twice, are errors at their place in the call.
// DEFINE: %{call} =
// DEFINE: %{run} = not %symreal generate %s --kernel %{call} -o %t.c 2>&1 | FileCheck %s --implicit-check-not='error:' --check-prefix
// REDEFINE: %{call} = 'Sum(2.0).add(a=0.5) -> return'
// RUN: %{run}=STATE
// STATE: call_refusals.cpp:{{[0-9:]+}}: error: the kernel writes 'k{{_?}}', which is not an output [SYM053]
// REDEFINE: %{call} = 'Sum(2.0).next(a=0.5) -> return'
// RUN: %{run}=COUNT
// COUNT: call_refusals.cpp:{{[0-9:]+}}: error: the kernel writes '{{.*}}count{{.*}}', which is not an output [SYM053]
// RUN: %symreal generate %s --kernel 'Sum(2.0).add(a=0.5, k_) -> return, k_' -o %t.c 2>&1 | FileCheck %s --check-prefix=OUTPUT
// OUTPUT: kernel add: 2 inputs, 0 parameters, 2 outputs
// RUN: rm %t.c

// REDEFINE: %{call} = 'g(x=2..-1, y=1) -> return'
// RUN: %{run}=ENDS
// ENDS: --kernel:1:5: error: the range from 2 to -1 ends below where it begins [SYM204]
// REDEFINE: %{call} = 'g(x=1, y=nan..1) -> return'
// RUN: %{run}=NAN
// NAN: --kernel:1:10: error: a range has two finite ends, and 'nan' is not finite [SYM204]
// REDEFINE: %{call} = 'g(x=0..1e400, y=1) -> return'
// RUN: %{run}=LARGE
// LARGE: --kernel:1:5: error: a range has two finite ends, and '1e400' is not finite [SYM204]
// REDEFINE: %{call} = 'g(x=one..-one, y=1) -> return'
// RUN: %{run}=WORDS
// WORDS: --kernel:1:3: error: the range of 'x' goes from 1 to -1 [SYM204]
// REDEFINE: %{call} = 'g(x=-inf, y=1) -> return'
// RUN: %{run}=INF
// INF: --kernel:1:5: error: '-inf' is not finite, and a kernel is recorded at finite numbers [SYM018]
// REDEFINE: %{call} = 'h(x[0:2]={1, 1e999}) -> return'
// RUN: %{run}=LIST
// LIST: --kernel:1:14: error: '1e999' is not finite, and a kernel is recorded at finite numbers [SYM018]
// RUN: echo "kernels: [{function: g, inputs: [x], parameters: [y], outputs: [return], range: [5, -5]}]" > %t.yaml
// RUN: not %symreal generate %s --config %t.yaml -o %t.c 2>&1 | FileCheck %s --check-prefix=YAML
// YAML: {{.*}}.yaml:1:{{[0-9]+}}: error: the range from 5 to -5 ends below where it begins [SYM204]
// RUN: not %symreal generate %s -o %t.c -- -DPRAGMA 2>&1 | FileCheck %s --check-prefix=PRAGMA
// PRAGMA: call_refusals.cpp:[[@LINE+21]]:41: error: the range from 3 to -3 ends below where it begins [SYM204]
// PRAGMA: call_refusals.cpp:[[@LINE+20]]:76: error: 'return' is an output already [SYM026]

// REDEFINE: %{call} = 'g(x=1, x=2, y=1) -> return'
// RUN: %{run}=INPUT
// INPUT: --kernel:1:8: error: 'x' is given twice [SYM018]
// REDEFINE: %{call} = 'h(x[0:2]=1) -> return, return'
// RUN: %{run}=RESULT
// RESULT: --kernel:1:24: error: 'return' is an output twice [SYM018]
// RUN: not ls %t.c
constexpr double one = 1;
class Sum {
  double k_;
  int count_ = 0;

public:
  explicit Sum(double k) : k_(k) {}
  double add(double a) { return k_ += a; }
  double next(double a) { return a * ++count_; }
};
#ifdef PRAGMA
#pragma symreal function input(x) range(3, -3) parameter(y) output(return, return)
#endif
double g(double x, double y) { return x * y; }
double h(double const *x) { return x[0] * x[1]; }
#ifdef PRAGMA
int main() { return g(1, 2) > 3; }
#endif
