#include <bicycle.h>
#include <cmath>

using namespace veh;

// clang-format off
#pragma symreal function input(pose.x, pose.y, pose.heading, u[0:2]) parameter(wheelbase_, offset_) output(rate->x, rate->y, rate->heading)
// clang-format on
void Bicycle::derivative(Pose const &pose, double const *u, Pose *rate) const {
  double const beta = slip(std::pow(offset_, 2) / wheelbase_, u[1]);
  rate->x = u[0] * std::cos(pose.heading + beta);
  rate->y = u[0] * std::sin(pose.heading + beta);
  rate->heading = u[0] / std::pow(offset_, 2) * std::sin(beta);
}

void Bicycle::advance(double seconds) { travelled_ += seconds; }

#pragma symreal function input(seconds, speed, travelled_) output(travelled_)
void Bicycle::advance(double seconds, double const &speed) { travelled_ += seconds * speed; }

#pragma symreal function input(ratio, angle) output(return)
double Bicycle::slip(double ratio, double angle) { return std::atan(ratio * std::tan(angle)); }
