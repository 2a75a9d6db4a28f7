/* What a call leaves out, or says wrongly, is told where it stands in the call, with what to type.
   DEFINE: %{call} =
   DEFINE: %{run} = not %symreal generate %s --kernel %{call} -o %t.c 2>&1 | FileCheck %s --check-prefix
   REDEFINE: %{call} = 'power(v[0:3]=1, r) -> return'
   RUN: %{run}=VALUE
   VALUE: --kernel:1:29: error: 'n' has no value, and a value of type int is part of the result: write n=1 [SYM018]
   VALUE: call_refused.c:{{[0-9:]+}}: note: double power(const double *v, int n, double r)
   REDEFINE: %{call} = 'power(v, n=3, r) -> return'
   RUN: %{run}=POINTER
   POINTER: --kernel:1:7: error: 'v' is a pointer and needs an extent: write v[0:6]=0.5 with its number of elements, or v=0 for none [SYM018]
   REDEFINE: %{call} = 'power(v[0:3], n=3) -> return'
   RUN: %{run}=NUMBER
   NUMBER: --kernel:1:29: error: 'r' is missing: write r=0.5 (an input), parameter r=0.5 or constant r=0.5 [SYM018]
   REDEFINE: %{call} = 'power(v[0:3]={1, 2}, n=3, r) -> return'
   RUN: %{run}=LIST
   LIST: --kernel:1:7: error: 'v[0:3]' has 3 elements, and 2 values are given [SYM018]
   REDEFINE: %{call} = 'power(v[3], n=3, r) -> return'
   RUN: %{run}=SECTION
   SECTION: --kernel:1:8: error: 'v[3]' gives no range of elements: write v[3:1] for one element, [0:3] for that many [SYM018]
   REDEFINE: %{call} = 'power(v[0:3], n=3, r)'
   RUN: %{run}=OUTPUTS
   OUTPUTS: --kernel:1:22: error: the outputs of 'power' are missing: add -> and the outputs, as in -> y[0:3], or -> return [SYM018]
   REDEFINE: %{call} = 'power(v[0:3], n=3, r -> return'
   RUN: %{run}=BRACKET
   BRACKET: --kernel:1:6: error: this '(' is not closed [SYM018]
   REDEFINE: %{call} = "power(v['(':3]=1, n=3, r) -> return"
   RUN: %{run}=QUOTED
   QUOTED: --kernel:1:8: error: this '[' is not closed [SYM018]
   REDEFINE: %{call} = 'powr(v[0:3], n=3, r) -> return'
   RUN: %{run}=NAME
   NAME: --kernel:1:1: error: no source defines a function 'powr' [SYM113]
   REDEFINE: %{call} = 'power(v[0:3], n=3, w=2, r) -> return'
   RUN: %{run}=ITEM
   ITEM: --kernel:1:20: error: {{.*}}'w'
   REDEFINE: %{call} = 'power(v[0:3]=half, n=3, r) -> return'
   RUN: %{run}=WORD
   WORD: --kernel:1:7: error: use of undeclared identifier 'half' [SYM018]
   REDEFINE: %{call} = 'power(v[0:3], constant n=3, parameter r=1..2) -> return'
   RUN: %{run}=RANGE
   RANGE: --kernel:1:41: error: a range is where the inputs of 'verify' lie; 'r' is not an input [SYM018]
   Nothing was written.
   RUN: not ls %t.c
*/
double power(const double *v, int n, double r)
{
    double sum = r;
    int i;
    for (i = 0; i < n; i++) sum += v[i] * v[i];
    return sum;
}
