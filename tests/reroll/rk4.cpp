// Steps of an integrator are a loop that carries the state; what all steps share is computed before it.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s --reroll -o %t/rk4.c
// RUN: FileCheck %s --input-file=%t/rk4.c
// CHECK: double const f{{[0-9]+}} = {{v|input}}[
// CHECK: for (int k = 0; k < 9{{[0-9]}}; ++k) {
// CHECK: c{{[0-9]+}} = {{.*}};
// CHECK-NEXT: c{{[0-9]+}} = {{.*}};
// CHECK-NEXT: }
// RUN: %symreal verify %s %t/rk4.c --samples=150 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: 150 samples, 1{{[0-9]+}} within the premises
// SAME: end{{\[0\]}} {{ *}}2 {{ *}}0 {{ *}}0{{$}}
#include <cmath>

struct State {
  double angle, speed;
};

static State slope(State s, double damping) { return {s.speed, -std::sin(s.angle) - damping * s.speed}; }
static State moved(State s, State by, double h) { return {s.angle + h * by.angle, s.speed + h * by.speed}; }

#pragma symreal function input(begin[0 : 2], damping) output(end[0 : 2])
void swing(double const *begin, double damping, double *end) {
  State s = {begin[0], begin[1]};
  double const h = 0.01;
  for (int k = 0; k < 100; ++k) {
    State const k1 = slope(s, damping), k2 = slope(moved(s, k1, h / 2), damping),
                k3 = slope(moved(s, k2, h / 2), damping), k4 = slope(moved(s, k3, h), damping);
    s.angle += h / 6 * (k1.angle + 2 * k2.angle + 2 * k3.angle + k4.angle);
    s.speed += h / 6 * (k1.speed + 2 * k2.speed + 2 * k3.speed + k4.speed);
  }
  end[0] = s.angle;
  end[1] = s.speed;
}

int main() {
  double const begin[2] = {0.5, 0.25};
  double end[2];
  swing(begin, 0.125, end);
}
