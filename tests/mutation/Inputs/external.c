#include <stdio.h>
double contact_force(double);
#pragma symreal external(contact_force) pure
#pragma symreal function input(x) output(return)
double kernel(double x) { return 2 * contact_force(x); }
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
