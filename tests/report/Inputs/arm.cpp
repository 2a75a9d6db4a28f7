// A line that would end a script: "</script><script>alert(1)</script>"
static double turn(double q, double l) {
  double const s = sin(q);
  return l * s;
}

namespace arm {
double reach(double q, double l) {
  double const far = turn(q, l) + l;
  if (far < 0) return 0;
  return far * gain;
}
} // namespace arm
