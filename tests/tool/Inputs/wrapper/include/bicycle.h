#pragma once

namespace veh {

struct Pose {
  double x, y, heading;
};

class Bicycle {
public:
  Bicycle(double wheelbase, double offset) : wheelbase_(wheelbase), offset_(offset) {}
  // Of the pose, by speed and steering angle.
  void derivative(Pose const &pose, double const *u, Pose *rate) const;
  void advance(double seconds);
  void advance(double seconds, double const &speed);
  static double slip(double ratio, double angle);
  double travelled() const { return travelled_; }

private:
  double wheelbase_, offset_, travelled_ = 0;
};

double clearance(Pose const &pose);
double clearance(Pose const &pose, double width);

} // namespace veh
