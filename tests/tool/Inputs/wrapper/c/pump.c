#include "pump.h"
#include <math.h>

double ambient = 1.2;
double losses;

#pragma symreal function input(pump->volume, pump->pressure, valve[0:n], losses) parameter(ambient) output(pump->volume, losses, return)
double stroke(struct pump *pump, double const *valve, int n)
{
    double work = 0;
    int i;
    for (i = 0; i < n; i++) work += valve[i] * pow(ambient, 1.4);
    pump->volume -= 0.1 * work;
    losses += work / pump->pressure;
    return work + losses;
}
