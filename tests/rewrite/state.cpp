// Objects of static storage that hold numbers are reported when they are used; constants are not.
// RUN: cd %S && %rewrite state.cpp | FileCheck state.cpp
// RUN: %same %s
#include <vector>

double gain = 2.0;
double table[2][3];
double const fixed = 3.0;
static const double list[2] = {1.0, 2.0};
int counter = 0;
struct Model { static double shared; static double const factor; double x; int n; } model;
// CHECK: REAL Model::shared = 1.0;
double Model::shared = 1.0;
// CHECK: REAL const Model::factor = 2.0;
double const Model::factor = 2.0;
std::vector<double> history;
// CHECK: REAL *first = &table[0][0];
double *first = &table[0][0];

double step(double x) {
  static double previous = 0.0;
  // CHECK: REAL old = REAL_READ("previous", "state.cpp:[[@LINE+1]]:16", REAL_STATE(previous, "state.cpp:[[@LINE-1]]:17"));
  double old = previous;
  // CHECK: REAL_WRITTEN("previous", {{.*}}, REAL_STATE(previous, "state.cpp:{{[0-9]+}}:17")) = x;
  previous = x;
  // CHECK: x += REAL_READ("gain", {{.*}}, REAL_STATE(gain, "state.cpp:{{[0-9]+}}:8")) * REAL_READ("table[1][2]", {{.*}}, REAL_STATE(table, "state.cpp:{{[0-9]+}}:8")[1][2]) * fixed + list[1] + REAL_READ("counter", {{.*}}, REAL_STATE(counter, "state.cpp:{{[0-9]+}}:5"));
  x += gain * table[1][2] * fixed + list[1] + counter;
  // CHECK: x += REAL_READ("model.x", {{.*}}, REAL_STATE(model, "state.cpp:{{[0-9]+}}:85").x) + REAL_READ("Model::shared", {{.*}}, REAL_STATE(Model::shared, "state.cpp:{{[0-9]+}}:30")) + REAL_READ("model.shared", {{.*}}, REAL_STATE(REAL_STATE(model, {{.*}}).shared, {{.*}})) + Model::factor;
  x += model.x + Model::shared + model.shared + Model::factor;
  // CHECK: REAL_CHANGED("history", {{.*}}, REAL_STATE(history, "state.cpp:{{[0-9]+}}:21")).push_back(x);
  history.push_back(x);
  // CHECK: return old + sizeof(gain) + sizeof table + REAL_READ("model.n", {{.*}}, REAL_STATE(model, "{{.*}}").n);
  return old + sizeof(gain) + sizeof table + model.n;
}
