/* A value for a structure is one for all of its numbers.
   RUN: rm -rf %t && mkdir %t && cp %s %t/arm.c && cp %S/Inputs/call_structures.yaml %t/.symreal.yaml
   RUN: cd %t && %symreal generate arm.c -o ./ 2> generated && FileCheck %s < generated
   RUN: FileCheck %s --check-prefix=NUMBERS < %t/generated
   NUMBERS: remark: no values are given for parts[0:3]: 'sum' is recorded at numbers between 0 and 1 [SYM019]
   CHECK: kernel step: 5 inputs, 0 parameters, 4 outputs
   CHECK: baked in {{ *}}body->joints = 0
   CHECK: kernel energy: 4 inputs, 0 parameters, 1 outputs
   CHECK: kernel sum: 6 inputs, 2 parameters, 1 outputs
   RUN: cd %t && %symreal verify arm.c step.c energy.c sum.c --samples=100 --min-samples=10 2> verified && FileCheck %s --check-prefix=SAME < verified
   SAME: kernel step, mode finite: 100 samples
   SAME: body{{.*}} 4 {{ *}}0 {{ *}}0
   SAME: kernel energy, mode finite: 100 samples
   SAME: return {{ *}}1 {{ *}}0 {{ *}}0
   SAME: kernel sum, mode finite: 100 samples
   SAME: return {{ *}}1 {{ *}}0 {{ *}}0
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
