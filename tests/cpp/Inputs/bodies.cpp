struct Body {
  double mass;
  double at[2];
};

// clang-format off: it takes the sections for something else
#pragma symreal function input(bodies[0:2]) parameter(g) output(moment[0:1])
// clang-format on
void moment_of(Body const *bodies, double g, double *moment) {
  moment[0] = 0;
  for (int i = 0; i < 2; ++i) moment[0] += bodies[i].mass * bodies[i].at[0] * g;
}

int main() {
  Body const bodies[2] = {{1, {2, 3}}, {4, {5, 6}}};
  double moment;
  moment_of(bodies, 9.81, &moment);
  return moment > 0 ? 0 : 1;
}
