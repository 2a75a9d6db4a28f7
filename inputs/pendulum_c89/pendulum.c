/*
 * pendulum.c - a driven, damped double pendulum, one Runge-Kutta step after another
 *
 * ANSI C, and C++ as well. State: the two angles from the vertical, then the
 * two angular velocities; the drive is a torque on the upper joint.
 */

#include <math.h>
#include <stdio.h>

#define NSTATE 4
#define NSTAGE 4
#define SQR(x) ((x) * (x))
#define GRAVITY ((double) 981 / 100)
#define STATE(name) double name[NSTATE]
#define FOR_EACH(p, v) for (p = (v); p < (v) + NSTATE; p++)

/* the system */
double mass[2] = {1.0, 0.7};
double length[2] = {0.9, 0.6};
double damping[2] = {0.05, 0.02};
double drive_amplitude = 0.8, drive_frequency = 3.0;

/* where it is now */
STATE(state) = {0.4, -0.3, 0.0, 0.5};

/* the classical method of order four */
static const double node[NSTAGE] = {0.0, 0.5, 0.5, 1.0};
static const double weight[NSTAGE] = {1.0, 2.0, 2.0, 1.0};

static double torque(double t)
{
    return drive_amplitude * cos(drive_frequency * t);
}

static void derivative(double t, const double *y, double *dydt)
{
    const double *angle = y, *speed = y + 2;
    double c, s, m, a, b, d, f1, f2, det;

    c = cos(angle[0] - angle[1]);
    s = sin(*angle - *(angle + 1));
    m = mass[0] + mass[1];

    /* [a b; b d] * acceleration = [f1 f2] */
    a = m * SQR(length[0]);
    b = mass[1] * length[0] * length[1] * c;
    d = mass[1] * SQR(length[1]);
    f1 = torque(t) - damping[0] * speed[0] - damping[1] * (speed[0] - speed[1])
        - mass[1] * length[0] * length[1] * s * SQR(speed[1])
        - m * GRAVITY * length[0] * sin(angle[0]);
    f2 = damping[1] * (speed[0] - speed[1])
        + mass[1] * length[0] * length[1] * s * SQR(speed[0])
        - mass[1] * GRAVITY * length[1] * sin(angle[1]);
    det = a * d - b * b;

    *dydt++ = speed[0];
    *dydt++ = speed[1];
    *dydt++ = (f1 * d - b * f2) / det;
    *dydt = (a * f2 - b * f1) / det;
}

#pragma symreal function input(state[0:4], t) parameter(mass[0:2], length[0:2], damping[0:2], drive_amplitude, drive_frequency, h) output(state[0:4])
void step(double t, double h)
{
    STATE(start);
    STATE(sum);
    STATE(slope);
    STATE(y);
    double *p, *q;
    int stage, i;

    q = start;
    FOR_EACH(p, state) *q++ = *p;
    FOR_EACH(p, sum) *p = 0;
    FOR_EACH(p, slope) *p = 0;
    for (stage = 0; stage < NSTAGE; stage++) {
        for (i = 0; i < NSTATE; i++)
            y[i] = start[i] + node[stage] * h * slope[i];
        derivative(t + node[stage] * h, y, slope);
        q = slope;
        FOR_EACH(p, sum) *p += weight[stage] * *q++;
    }
    p = sum;
    q = state;
    for (i = NSTATE; i--; p++, q++)
        *q += h * *p / 6;
}

int main(void)
{
    double t = 0.0, h = 0.01;
    int i;

    for (i = 0; i < 100; i++) {
        step(t, h);
        t += h;
        if (i % 20 == 19)
            printf("%.4f %.17g %.17g %.17g %.17g\n", t, state[0], state[1], state[2], state[3]);
    }
    return 0;
}
