/* A structure of C is annotated as a whole: nested ones, arrays in them and arrays of them. The generated structs have
   their members' names; integers among them are constants, which are listed and are no hidden state.
   RUN: rm -rf %t && mkdir %t
   RUN: %symreal generate %s -o %t/step.c --wrapper --graph %t/step.graph -- -std=c99 2>&1 | FileCheck %s --check-prefix=LIST
   RUN: FileCheck %s --check-prefix=HEADER < %t/step.h
   RUN: FileCheck %s --check-prefix=GRAPH < %t/step.graph
   RUN: %symreal verify --samples=100 --min-samples=10 %s %t/step.c -- -std=c99 2>&1 | FileCheck %s --check-prefix=SAME
   RUN: %symreal opt %t/step.graph -o %t/again.c --lang c
   RUN: grep -vE "_H|functions of the original" %t/step.h > %t/header && grep -v _H %t/again.h | diff %t/header -
   RUN: %cc -std=c99 -DUSE -I%t %s %t/step.c -lm -o %t/use && %cc -std=c99 -Wno-unknown-pragmas %s -lm -o %t/original
   RUN: %t/use > %t/used && %t/original | diff - %t/used
*/
#include <stdio.h>

struct vector { double x, y; };
typedef struct {
    int kind; /* between the numbers */
    struct vector position, velocity;
    double spin[2][2];
    unsigned char flags[3];
} body;
struct params { double gravity; long order; double drag[2]; };

#pragma symreal function input(*s, bodies[0:n]) parameter(P[0:1]) output(bodies[0:n], *out)
void step(const struct vector *s, body *bodies, int n, struct params const *P, struct vector *out)
{
    int i;
    out->x = s->x;
    out->y = P[0].order * s->y;
    for (i = 0; i < n; ++i) {
        body *b = &bodies[i];
        b->velocity.y -= P->gravity * (b->kind == 1 ? 2 : 1);
        b->position.x += b->velocity.x * P->drag[0] + s->x;
        b->position.y += b->velocity.y * P->drag[1] + s->y;
        b->spin[1][0] *= 0.5;
        out->y += b->spin[0][1] * b->spin[1][0];
    }
}

static struct vector const wind = {0.25, -1.5};
static body bodies[2] = {{0, {1, 2}, {3, 4}, {{5, 6}, {7, 8}}, {0}}, {1, {-1, -2}, {-3, -4}, {{9, 10}, {11, 12}}, {1}}};
static struct params P = {9.81, 2, {0.5, 0.25}};

#ifndef USE
int main(void)
{
    struct vector out;
    step(&wind, bodies, 2, &P, &out);
    printf("%.17g %.17g %.17g\n", bodies[1].position.y, bodies[0].spin[1][0], out.y);
    return 0;
}
#else
#include "step.h"
#include <string.h>
int main(void)
{
    input_values in = {{0.25, -1.5}, {{{1, 2}, {3, 4}, {{5, 6}, {7, 8}}}, {{-1, -2}, {-3, -4}, {{9, 10}, {11, 12}}}}};
    parameter_values p = {.P = {{.gravity = 9.81, .drag = {0.5, 0.25}}}};
    double constants[constant_count + 1];
    output_values out;
    preprocess((double const *)&p, constants);
    compute((double const *)&in, constants, (double *)&out);
    printf("%.17g %.17g %.17g\n", out.bodies[1].position.y, out.bodies[0].spin[1][0], out.out.y);
    return 0;
}
#endif

/* LIST: kernel step: 18 inputs, 3 parameters, 18 outputs
   LIST-NOT: SYM017
   LIST-DAG: baked in {{.*}} = 0, 1
   LIST-DAG: baked in {{.*}}order = 2
   HEADER: typedef struct input_values {
   HEADER-NEXT:   struct {
   HEADER-NEXT:     double x;
   HEADER-NEXT:     double y;
   HEADER-NEXT:   } s;
   HEADER-NEXT:   struct {
   HEADER-NEXT:     struct {
   HEADER-NEXT:       double x;
   HEADER-NEXT:       double y;
   HEADER-NEXT:     } position;
   HEADER-NEXT:     struct {
   HEADER-NEXT:       double x;
   HEADER-NEXT:       double y;
   HEADER-NEXT:     } velocity;
   HEADER-NEXT:     double spin[2][2];
   HEADER-NEXT:   } bodies[2];
   HEADER-NEXT: } input_values;
   HEADER: Baked in
   GRAPH: input "bodies[0:n]" [2] { "position" { "x" "y" } "velocity" { "x" "y" } "spin" [2] [2] } at
   SAME: 100 within the premises
   SAME: {{^}}  bodies[{{.*}}16 {{ *}}0 {{ *}}0
   SAME: {{^}}  out.{{.*}}2 {{ *}}0 {{ *}}0
*/
