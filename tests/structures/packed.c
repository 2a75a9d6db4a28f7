/* A member of a packed structure, and such a structure as a whole: no reference can be bound to them.
   RUN: %symreal generate %s -o %t.c
   RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s
   RUN: cp %s %t.cpp && %symreal generate %t.cpp -o %t.2.c && %symreal verify --samples=100 --min-samples=10 %t.cpp %t.2.c 2>&1 | FileCheck %s
*/
#include <stdio.h>

#pragma pack(push, 1)
struct message { char id; double value, values[2]; };
#pragma pack(pop)
struct __attribute__((packed)) record { short kind; double x; };

#pragma symreal function input(m->value, *r) output(m->values[0:2], r->x)
void twice(struct message *m, struct record *r)
{
    m->values[0] = 2 * m->value + r->x;
    m->values[1] = r->x * m->value;
    r->x = r->x + 1;
}

int main(void)
{
    struct message m = {'m', 3, {0, 0}};
    struct record r = {1, 5};
    twice(&m, &r);
    printf("%g\n", m.values[0]);
    return 0;
}

/* CHECK: 100 within the premises
   CHECK: 2 {{ *}}0 {{ *}}0
*/
