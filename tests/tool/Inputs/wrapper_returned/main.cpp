#include "lib.h"

#include <cstdio>
#include <initializer_list>

int main() {
  for (double x : {1.5, -0.25}) {
    std::printf("%g %g\n", root(x).real(), root(x).imag());
    std::printf("%g %g %g\n", powers(x)[0], powers(x)[1], powers(x)[2]);
    std::printf("%zu %g %g\n", series(x).size(), series(x)[0], series(x)[3]);
    Pose const p = pose(x);
    std::printf("%g %g %g %zu %g %g\n", p.at[1], p.heading.angle, p.joints[0], p.joints.size(), p.joints[1],
                p.phase.imag());
    std::printf("%g %g %g\n", hidden(x).sum(), both(x).first, both(x).second);
  }
}
