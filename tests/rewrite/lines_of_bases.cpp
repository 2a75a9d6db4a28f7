// What is inserted into a class is one line without comments, and moves no line: __LINE__ stays, and so does the object code.
// RUN: %symreal verify --numeric %s -- -O1 | FileCheck %s --check-prefix=SAME
// RUN: %rewrite %s | FileCheck %s
// SAME: 1 of 1 translation units have identical object code
#include <cassert>
#include <type_traits>
template <int from, int to>
// CHECK: REAL_MEMBERS(public, static_cast<std::integral_constant<bool, from == to || from == 3> const &>(*this))
struct Allowed : public std::integral_constant<bool, from == to || // the same,
                                                         from == 3> {}; /* or three */
double at(double const *x, int n, int i) {
  static_assert(Allowed<3, 4>::value, "");
  assert(i < n);
  return x[i];
}
