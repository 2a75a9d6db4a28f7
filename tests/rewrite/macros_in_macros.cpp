// The expression that needs a conversion begins in the body of a macro and ends in one that the body names.
// RUN: %same %s
// RUN: %rewrite %s | FileCheck %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100

namespace flags {
int flag_depth = 2;
double flag_scale = 1;
} // namespace flags
#define FLAG(name) flag_##name
// CHECK: #define GET(name) (REAL_READ({{.*}}, REAL_STATE(::flags::FLAG(name), {{.*}})))
#define GET(name) (::flags::FLAG(name))
// CHECK: #define SET(name, value) (void)(REAL_WRITTEN({{.*}}, {{.*}}::flags::FLAG(name){{.*}}) = value)
#define SET(name, value) (void)(::flags::FLAG(name) = value)
int main() {
  double x = 1, y;
#pragma symreal input(x) range(1, 2) scratch(flags::flag_depth, flags::flag_scale)
  SET(depth, 3);
  SET(scale, x * 2);
  y = GET(depth) + GET(scale);
#pragma symreal output(y) generate("y.c")
  return y > 100;
}
