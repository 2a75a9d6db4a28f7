/* A value for a structure is one for all of its numbers.
   RUN: rm -rf %t && mkdir %t && cp %s %t/arm.c && cd %t
   DEFINE: %{call} =
   DEFINE: %{run} = cd %t && %symreal generate arm.c --kernel %{call} -o k.c 2> %t.log && %symreal verify arm.c k.c --samples=100 --min-samples=10 --kernel %{call} 2>> %t.log

   REDEFINE: %{call} = 'step(*body=0.5, dt=0.1) -> *body'
   RUN: %{run} && FileCheck %s --check-prefix=POINTER < %t.log
   POINTER: kernel step: 5 inputs, 0 parameters, 4 outputs
   POINTER: baked in {{ *}}body->joints = 0
   POINTER: kernel step, mode finite: 100 samples
   POINTER: body{{.*}} 4 {{ *}}0 {{ *}}0

   REDEFINE: %{call} = 'energy(body=0.2..0.8) -> return'
   RUN: %{run} && FileCheck %s --check-prefix=VALUE < %t.log
   VALUE: kernel energy: 4 inputs, 0 parameters, 1 outputs
   VALUE: return {{ *}}1 {{ *}}0 {{ *}}0

   REDEFINE: %{call} = 'sum(parts[0:3], parameter *scale=2, n=3) -> return'
   RUN: %{run} && FileCheck %s --check-prefix=ARRAY < %t.log
   ARRAY: remark: no values are given for parts[0:3]: 'sum' is recorded at numbers between 0 and 1 [SYM019]
   ARRAY: kernel sum: 6 inputs, 2 parameters, 1 outputs
   ARRAY: return {{ *}}1 {{ *}}0 {{ *}}0
*/
struct vec { double x, y; };
struct body { struct vec at; int joints; double v[2]; };

void step(struct body *body, double dt)
{
    body->at.x += dt * body->v[0];
    body->at.y += dt * body->v[1] * (body->joints + 1);
}

double energy(struct body body) { return body.at.x * body.v[0] + body.at.y * body.v[1]; }

double sum(struct vec const *parts, struct vec *scale, int n)
{
    double sum = 0;
    for (int i = 0; i < n; i++) sum += parts[i].x * scale->x + parts[i].y * scale->y;
    return sum;
}
