// Crank, coupler and rocker on a base.
#include "constrained.h"
#include "model.h"

static double const base = 0.4, crank = 0.1, coupler = 0.35, rocker = 0.25;
static Mechanism<3, 4, 0> const mechanism = {{{0.4, 0.001}, {0.9, 0.01}, {0.7, 0.004}},
                                             {{-1, 0, {0, 0}, {-crank / 2, 0}},
                                              {0, 1, {crank / 2, 0}, {-coupler / 2, 0}},
                                              {1, 2, {coupler / 2, 0}, {rocker / 2, 0}},
                                              {2, -1, {-rocker / 2, 0}, {base, 0}}},
                                             {0},
                                             1.5,
                                             0.04,
                                             50.0};

#pragma symreal function input(state[0 : 18]) output(rate[0 : 18])
void rates(double const *state, double *rate) { mechanism_rates(mechanism, state, rate); }

void initial_state(double *state) {
  // Where the circles about the crank's end and about the rocker's foot meet.
  double const angle = 1.0, x = crank * std::cos(angle), y = crank * std::sin(angle);
  double const dx = base - x, dy = -y, distance = std::sqrt(dx * dx + dy * dy);
  double const along = (distance * distance + coupler * coupler - rocker * rocker) / (2 * distance);
  double const across = std::sqrt(coupler * coupler - along * along);
  double const px = x + (along * dx - across * dy) / distance, py = y + (along * dy + across * dx) / distance;
  double const q[9] = {x / 2,           y / 2,        angle,
                       (x + px) / 2,    (y + py) / 2, std::atan2(py - y, px - x),
                       (base + px) / 2, py / 2,       std::atan2(py, px - base)};
  for (int i = 0; i < 18; i++) state[i] = i < 9 ? q[i] : 0;
}

int main() { return print_rates(18); }
