// Structures in a symbolic main that was written by hand.
// RUN: %symreal generate %s -o %t.c && FileCheck %s < %t.c
// RUN: FileCheck %s --check-prefix=HEADER < %t.h
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=VERIFY
#include <symreal/symbolic_main.h>

#include <vector>

struct Pose {
  REAL x, y;
};
class Body {
public:
  Body() : history(2, REAL(0.25)) {}
  REAL energy() const { return mass * (pose.x * pose.x + pose.y * pose.y) + history[1]; }
  Pose pose = {0.5, 0.75};
  std::vector<REAL> history;

private:
  REAL mass = 2.0;
  int joints = 3;
};

int main() {
  Body body;
  Pose limits[2] = {{1, 2}, {3, 4}};
  struct {
    REAL energy, sum;
  } result;
  input("body", body);
  parameter("limits", limits);
  result.energy = body.energy();
  result.sum = limits[0].x + limits[1].y;
  output("result", result);
  generate_code("result.c");
}
// HEADER: } pose;
// HEADER-NEXT: double history[2];
// HEADER-NEXT: double mass;
// HEADER-NEXT: } body;
// HEADER: } limits[2];
// HEADER: double energy;
// HEADER-NEXT: double sum;
// HEADER-NEXT: } result;
// HEADER: body.joints = 3
// CHECK: void compute
// CHECK: constants
// VERIFY: result{{.*}} 2 {{ *}}0 {{ *}}0
