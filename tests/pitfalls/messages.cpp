// Text of symbolic values that only leaves the program, and text of others that is read: neither is in the way.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c --run-on 2>&1 | FileCheck %s --implicit-check-not=error:
// RUN: %symreal verify %s %t.c --samples=100
// CHECK: program| sum 1.5 of 0.5 and 1
// CHECK: program| [0.5 1 ] 2 numbers
// CHECK: program| stream 0.5
// CHECK: program| alpha 0.5
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

static void note_down(char const *format, ...) {
  char line[200];
  va_list list;
  va_start(list, format);
  std::vsnprintf(line, sizeof line, format, list);
  va_end(list);
  std::puts(line);
}

static double gain(char const *text) { return text[0] == '+' ? std::atof(text + 1) : std::atof(text); }

struct Point {
  double x, y;
};
static std::ostream &operator<<(std::ostream &out, Point const &p) { return out << '(' << p.x << ", " << p.y << ')'; }

#pragma symreal function input(x[0:2]) output(return)
double sum(double const *x) {
  note_down("sum %g of %g and %g", x[0] + x[1], x[0], x[1]);
  char message[100];
  int length = std::sprintf(message, "[");
  for (int i = 0; i < 2; ++i)
    length += std::snprintf(message + length, sizeof message - static_cast<std::size_t>(length), "%g ", x[i]);
  std::sprintf(message + length, "] %d numbers", 2);
  std::puts(message);
  std::ostringstream out;
  out << "stream " << x[0] << Point{x[0], x[1]};
  std::cout << out.str() << '\n';
  if (message[0] == 0) throw std::runtime_error("no " + std::to_string(x[0]));
  std::map<std::string, double> const gains = {{"alpha", gain("+2.5")}, {"beta", gain("0.25")}};
  std::string const name = "alpha";
  std::cout << name << ' ' << x[0] << std::endl;
  return x[0] * gains.at(name) + x[1] * gains.at("beta");
}

int main() {
  double const x[2] = {0.5, 1.0};
  std::printf("%g\n", sum(x));
}
