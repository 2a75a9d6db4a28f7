#ifndef STEP_H
#define STEP_H
#define HALF 0.5
void step(double x[2], double h);
#endif
