#include "bicycle.h"

#include <cmath>
#include <cstdio>
#include <initializer_list>

double grip_table[2] = {7, 8};

int main() {
  veh::Pose pose = {1, 2, 0.3}, rate;
  double const u[2] = {4, 0.2};
  for (double offset : {1.1, 1.1, 1.3, std::nan(""), std::nan(""), 1.1}) {
    veh::Bicycle const bicycle(2.7, offset);
    for (int i = 0; i < 2; ++i) bicycle.derivative(pose, u, &rate);
    std::printf("%.17g %.17g %.17g\n", rate.x, rate.y, rate.heading);
  }
  veh::Bicycle bicycle(2.7, 1.1);
  bicycle.advance(2);
  bicycle.advance(0.5, 3);
  bicycle.advance(0.25, 3);
  std::printf("%.17g %.17g\n", bicycle.travelled(), veh::Bicycle::slip(0.4, 0.2));
  for (double y : {1.0, 2.5}) std::printf("%.17g\n", veh::clearance({1, y, 0}));
}
