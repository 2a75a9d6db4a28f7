/* --kernel calls a function that no program calls: the tool writes that program, beside the source and in no file. A source in
   C stays one, with its static functions, and its own main is not in the way.
   RUN: rm -rf %t && mkdir %t && cp %s %t/arm.c && cd %t
   DEFINE: %{call} =
   DEFINE: %{options} =
   DEFINE: %{run} = cd %t && %symreal generate arm.c --kernel %{call} %{options} -o k.c -- -std=c99 2> %t.log && %symreal verify arm.c k.c --samples=100 --min-samples=10 --kernel %{call} -- -std=c99 2>> %t.log

   REDEFINE: %{call} = 'torque(q[0:n]=0.3, qd[0:n]={1, 2}, parameter m=1.2, n=2) -> tau[0:n]'
   RUN: %{run} && FileCheck %s --check-prefix=ARRAYS < %t.log
   ARRAYS: kernel torque: 4 inputs, 1 parameters, 2 outputs
   ARRAYS: kernel torque, mode finite: 100 samples
   RUN: ls %t | FileCheck %s --check-prefix=FILES
   FILES: arm.c
   FILES-NEXT: k.c
   FILES-NEXT: k.h
   FILES-NOT: {{.}}

   So do those that the configuration lists; an argument may have the name of the function.
   RUN: mkdir %t/listed && cp %s %t/listed/arm.c && cp %S/Inputs/call_c.yaml %t/listed/.symreal.yaml
   RUN: cd %t/listed && %symreal generate arm.c -o ./ -- -std=c99 2> generated && FileCheck %s < generated
   RUN: FileCheck %s --check-prefix=STATIC < %t/listed/generated
   STATIC: remark: no values are given for frame[0:2][0:2]: 'inertia' is recorded at numbers between 0 and 1 [SYM019]
   CHECK: kernel inertia: 5 inputs, 0 parameters, 1 outputs
   CHECK: kernel move: 4 inputs, 0 parameters, 1 outputs
   CHECK: kernel rows: 6 inputs, 0 parameters, 3 outputs
   CHECK: kernel slope: 1 inputs, 0 parameters, 1 outputs
   RUN: cd %t/listed && %symreal verify arm.c inertia.c move.c rows.c slope.c --samples=100 --min-samples=10 -- -std=c99 2> verified && FileCheck %s --check-prefix=SAME < verified
   SAME: kernel inertia, mode finite: 100 samples
   SAME: kernel move, mode finite: 100 samples
   SAME: kernel rows, mode finite: 100 samples
   SAME: kernel slope, mode finite: 100 samples

   REDEFINE: %{call} = 'limit(x=3, mode=HARD) -> return'
   REDEFINE: %{options} = --decisions=guard
   RUN: %{run} && FileCheck %s --check-prefix=PATH < %t.log
   PATH: kernel limit: 1 inputs
   PATH: kernel limit, mode finite: 100 samples
   RUN: grep -F 'x > 2' %t/k.h
*/
#include <math.h>
#include <stdio.h>

double gravity = 9.8;
struct body {
    double x, v[2];
    int id;
};
enum mode { SOFT, HARD };

static double inertia(double frame[2][2])
{
    return gravity * (frame[0][0] * frame[1][1] - frame[0][1] * frame[1][0]);
}

void torque(const double *q, const double *qd, double m, double *tau, int n)
{
    int i;
    for (i = 0; i < n; i++) tau[i] = pow(m, 3) * sin(q[i]) + qd[i] * qd[(i + 1) % n];
}

void move(struct body *body, double dt)
{
    body->x += dt * body->v[0] + body->v[1];
}

static double first(double const *row) { return row[0]; }
static void rows(double **a, double *y, double (*at)(double const *))
{
    int i;
    for (i = 0; i < 3; i++) y[i] = at(a[i]) - a[i][1];
}

double slope(double slope) { return slope * slope; }

double limit(double x, enum mode mode)
{
    if (mode == SOFT) return x / (1 + x);
    return x > 2 ? 2 : x;
}

int main(int argc, char **argv)
{
    double frame[2][2] = {{1, 2}, {3, 4}}, q[1] = {1}, qd[1] = {2}, tau[1];
    struct body body = {1, {2, 3}, 4};
    double *a[3] = {q, qd, tau};
    torque(q, qd, 1, tau, argc);
    move(&body, 1);
    rows(a, tau, first);
    printf("%g %g %s %g\n", inertia(frame), tau[0], argv[0], limit(1, HARD));
    return 0;
}
