// An aircraft's longitudinal motion: lift and drag from tables over the angle of attack, thrust from a table over Mach
// number and altitude, actuators that saturate.
#include <algorithm>
#include <cmath>
#include <cstdio>

constexpr double pi = 3.14159265358979323846;
constexpr int ANGLES = 12, MACHS = 6, ALTITUDES = 6;

// Over the angle of attack from -10 to 45 degrees, every 5.
static double const lift_table[ANGLES] = {-0.77, -0.24, 0.25, 0.70, 1.10, 1.42, 1.66, 1.82, 1.90, 1.88, 1.80, 1.68};
static double const drag_table[ANGLES] = {0.067, 0.029, 0.022, 0.042, 0.092, 0.170, 0.275, 0.401, 0.546, 0.708, 0.880, 1.052};
// kN over Mach number 0, 0.2, ... 1 and altitude 0, 3, ... 15 km.
static double const thrust_table[MACHS][ALTITUDES] = {
    {56.4, 41.0, 27.8, 18.0, 10.5, 5.6}, {57.1, 41.5, 28.4, 18.6, 11.0, 6.0}, {58.7, 43.6, 30.1, 20.2, 12.1, 6.8},
    {60.5, 46.1, 33.0, 22.5, 13.9, 8.0}, {62.3, 48.9, 36.5, 25.7, 16.2, 9.6}, {63.8, 51.5, 39.8, 29.4, 19.1, 11.7}};

static double limit(double x, double low, double high) {
  if (x < low) return low;
  if (x > high) return high;
  return x;
}

static double along(double const table[ANGLES], double degrees) {
#pragma symreal table(table[0:ANGLES])
  double const s = limit(degrees, -10.0, 44.9) * 0.2 + 2.0;
  int const k = (int)s;
  return table[k] + (s - k) * (table[k + 1] - table[k]);
}

static double thrust(double mach, double altitude) {
  double const s = std::clamp(mach / 0.2, 0.0, MACHS - 1.001), t = std::clamp(altitude / 3000.0, 0.0, ALTITUDES - 1.001);
  int const i = (int)s, j = (int)t;
  double const u = s - i, w = t - j;
  return 1000.0 * ((1 - u) * ((1 - w) * thrust_table[i][j] + w * thrust_table[i][j + 1]) +
                   u * ((1 - w) * thrust_table[i + 1][j] + w * thrust_table[i + 1][j + 1]));
}

// state: speed (m/s), angle of attack, pitch rate, pitch angle (rad), altitude (m)
#pragma symreal function input(state[0:5]) input(throttle, elevator) parameter(mass, inertia) output(rate[0:5])
void longitudinal(double const state[5], double throttle, double elevator, double mass, double inertia, double rate[5]) {
  double const area = 27.9, chord = 3.45, g = 9.80665;
  double const speed = state[0], alpha = state[1], q = state[2], theta = state[3], altitude = state[4];

  // Troposphere and the isothermal layer above it.
  double temperature, density;
  if (altitude < 11000.0) {
    temperature = 288.15 - 0.0065 * altitude;
    density = 1.225 * std::pow(temperature / 288.15, 4.2559);
  } else {
    temperature = 216.65;
    density = 0.36391 * std::exp(-(altitude - 11000.0) / 6341.6);
  }
  double const mach = speed / std::sqrt(1.4 * 287.05 * temperature);
  double const pressure = 0.5 * density * speed * speed;

  double const deflection = limit(elevator, -25.0 * pi / 180, 25.0 * pi / 180);
  double const power = std::min(std::max(throttle, 0.0), 1.0);
  double const degrees = alpha * 180 / pi;
  double const lift = pressure * area * (along(lift_table, degrees) + 0.43 * deflection);
  double const drag = pressure * area * (along(drag_table, degrees) + (mach > 0.9 ? 0.1 * (mach - 0.9) : 0.0));
  double const moment = pressure * area * chord * (-0.02 - 0.18 * alpha - 0.6 * deflection - 5.0 * q * chord / (2 * speed));
  double const push = power * thrust(mach, altitude);

  double const path = theta - alpha;
  rate[0] = (push * std::cos(alpha) - drag) / mass - g * std::sin(path);
  rate[1] = q - (push * std::sin(alpha) + lift) / (mass * speed) + g * std::cos(path) / speed;
  rate[2] = moment / inertia;
  rate[3] = q;
  rate[4] = speed * std::sin(path);
}

int main() {
  double const state[5] = {150.0, 0.08, 0.01, 0.1, 4000.0};
  double rate[5];
  longitudinal(state, 0.4, -0.03, 9300.0, 75000.0, rate);
  for (double value : rate) std::printf("%.10g ", value);
  std::printf("\n");
}
