// N steps of the classical method of Runge and Kutta for a damped pendulum.
#include <cmath>
#include <cstdlib>

struct State {
  double angle, speed;
};

static State slope(State s, double damping) { return {s.speed, -std::sin(s.angle) - damping * s.speed}; }
static State moved(State s, State by, double h) { return {s.angle + h * by.angle, s.speed + h * by.speed}; }

#pragma symreal function input(begin[0 : 2], damping) constant(steps) output(end[0 : 2])
void swing(double const *begin, double damping, int steps, double *end) {
  State s = {begin[0], begin[1]};
  double const h = 0.01;
  for (int k = 0; k < steps; k++) {
    State const k1 = slope(s, damping), k2 = slope(moved(s, k1, h / 2), damping),
                k3 = slope(moved(s, k2, h / 2), damping), k4 = slope(moved(s, k3, h), damping);
    s.angle += h / 6 * (k1.angle + 2 * k2.angle + 2 * k3.angle + k4.angle);
    s.speed += h / 6 * (k1.speed + 2 * k2.speed + 2 * k3.speed + k4.speed);
  }
  end[0] = s.angle;
  end[1] = s.speed;
}

#ifndef NO_MAIN
int main(int, char **argv) {
  double const begin[2] = {0.5, 0.25};
  double end[2];
  swing(begin, 0.125, std::atoi(argv[1]), end);
}
#endif
