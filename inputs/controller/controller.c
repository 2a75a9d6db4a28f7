/*
 * controller.c - a heater's controller: a hysteresis switch, a rate limit and a
 * proportional-integral law that does not wind up
 *
 * What it remembers from one step to the next stands in statics.
 */

#include <math.h>
#include <stdio.h>

#define LIMIT(x, low, high) ((x) < (low) ? (low) : (x) > (high) ? (high) : (x))

/* the state: whether the boost stage is on, the integral, the last output */
static double boost = 0.0, integral = 0.1, last = 0.2;

#pragma symreal function input(temperature, wanted, boost, integral, last) parameter(gain, reset, dt) output(return, boost, integral, last)
double control(double temperature, double wanted, double gain, double reset, double dt)
{
    double error = wanted - temperature, raw, power;

    /* hysteresis: on below 5 K under the setpoint, off above 1 K under it */
    if (error > 5.0)
        boost = 1.0;
    else if (error < 1.0)
        boost = 0.0;

    raw = gain * error + integral;
    power = LIMIT(raw, 0.0, 1.0);

    /* integrate only while the actuator is not saturated, or towards the inside */
    if ((raw <= 1.0 || error < 0.0) && (raw >= 0.0 || error > 0.0))
        integral += gain / reset * error * dt;

    power += 0.5 * boost;
    if (fabs(power - last) > 0.25 * dt)
        power = last + (power > last ? 0.25 * dt : -0.25 * dt);
    last = power;
    return power;
}

int main(void)
{
    double temperature = 290.0, wanted = 300.0, power = 0.0;
    int step;

    for (step = 0; step < 200; step++) {
        power = control(temperature, wanted, 0.08, 30.0, 0.5);
        temperature += 0.5 * (power * 1.2 - 0.02 * (temperature - 285.0));
    }
    printf("%.10g %.10g\n", temperature, power);
    return 0;
}
