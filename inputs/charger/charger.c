/*
 * charger.c - a charger for one lithium cell: constant current, then constant
 * voltage, by a state machine that lives in statics
 *
 * Generated code has no integers. The charging phase is therefore fixed in it:
 * with -DONE_PHASE the source says that this is meant, and what has to happen
 * at the end of the phase becomes a guard, at which the original takes over.
 */

#include <stdio.h>

enum phase { PRECHARGE, CURRENT, VOLTAGE, FULL };

static enum phase phase = PRECHARGE;
static int low_samples = 0; /* how often in a row the current was low */
static double integral = 0.0;

#ifdef ONE_PHASE
#pragma symreal function input(voltage, current, integral) parameter(capacity, gain, dt) constant(phase) call(100) output(return, integral)
#else
#pragma symreal function input(voltage, current, integral) parameter(capacity, gain, dt) call(100) output(return, integral)
#endif
double charge(double voltage, double current, double capacity, double gain, double dt)
{
    double command = 0.0;

    switch (phase) {
    case PRECHARGE:
        command = 0.1 * capacity;
        if (voltage > 3.0) phase = CURRENT;
        break;
    case CURRENT:
        command = 0.5 * capacity;
        integral = command;
        if (voltage > 4.19) phase = VOLTAGE;
        break;
    case VOLTAGE:
        integral += gain * (4.2 - voltage) * dt;
        command = integral + 2.0 * gain * (4.2 - voltage);
        if (current < 0.05 * capacity)
            low_samples++;
        else
            low_samples = 0;
        if (low_samples > 5) phase = FULL;
        break;
    case FULL: break;
    }
    return command;
}

int main(void)
{
    double const capacity = 2.5, dt = 10.0;
    double charged = 0.01, current = 0.0; /* Ah, A */
    int step;

    for (step = 0; step < 2000 && phase != FULL; step++) {
        double const open = 2.9 + 2.4 * charged - 1.3 * charged * charged + 0.27 * charged * charged * charged;
        double const voltage = open + 0.05 * current;
        current = charge(voltage, current, capacity, 0.02, dt);
        charged += current * dt / 3600.0;
    }
    printf("%d %.10g %.10g\n", step, charged, integral);
    return 0;
}
