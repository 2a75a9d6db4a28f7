// A word at the beginning of a line that is continued, as in a macro, is the word alone.
// RUN: %symreal scan %s | FileCheck %s
// RUN: %rewrite %s | FileCheck %s --check-prefix=TEXT
// CHECK: {{^ +}}1  if, because of 'throw'; first at {{.*}}continued_line.cpp:8:1
#include <stdexcept>
#include <string>
#define REQUIRE(condition, message) /* the next line begins with its word */                                           \
if (!(condition)) {                                                                                                    \
    throw std::runtime_error(std::string(message));                                                                    \
} else
// TEXT: #define REQUIRE(condition, message) {{.*}} \
// TEXT-NEXT: if (!(condition)) {
double root(double x) {
  REQUIRE(x > 0, "negative") return x / 2;
}
