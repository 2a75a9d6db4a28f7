// The aircraft of inputs/vehicle. x: the state, the throttle, the elevator; z: mass and inertia.
void longitudinal(double const state[5], double throttle, double elevator, double mass, double inertia, double rate[5]);

void model(double const *x, double const *z, double *y) { longitudinal(x, x[5], x[6], z[0], z[1], y); }
