// Values that are no double and that no call can change, or that decide nothing, are no state.
// RUN: %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not="error:"
// RUN: %symreal verify %s %t.c --samples=200
// CHECK: warning: 'gains' has members that are not double and stay as they are: 'unit' [SYM072]
// CHECK: kernel scaled: 6 inputs
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

struct Law {
  virtual double of(double x) const { return x; }
  virtual ~Law() = default;
};

static float gain = 2, table[] = {1, 2};                               // never changed, and not to be named elsewhere
static double (*const functions[])(double) = {std::sin, std::cos};     // constant
static double (*chosen)(double) = std::exp;                            // never changed
static double const coefficients[] = {0.5, 0.25}, *const at = coefficients;
static std::string const kind = "slow";

struct Body {
  double mass, *shared;
  std::string name; // is printed only
  Body const *parent;
};

// All members of an annotated object are baked in, which is known.
struct Gains {
  double p;
  float unit;
  bool on;
  double (*law)(double);
  std::string name;
};

// As arguments they are the caller's choice, as an integer is.
static double apply(double x, float factor, double (*law)(double), std::function<double(double)> const &other,
                    std::string const &mode, Law const &curve, double const *weights) {
  return law(x) * factor + other(x) + (mode == "fast" ? 1 : 2) + curve.of(x) + weights[1];
}

static double shared = 3;
static std::vector<double> loads = {1, 2};
static Body parent = {1, &shared, "parent", nullptr};
static Body *bodies = &parent;

#pragma symreal function input(x, body.mass, loads[0:2], shared, gains) output(return)
double scaled(double x, Body &body, Gains &gains) {
  float own = gain;
  own += table[1];
  double (*local)(double) = functions[1];
  std::function<double(double)> const closure = [x](double y) { return x + y; };
  std::unique_ptr<Law> const law = std::make_unique<Law>();
  std::string text = kind;
  text += "est";
  double y = x * own + local(x) + chosen(x) + closure(x) + law->of(x) + at[1] * body.mass;
  for (std::size_t k = 0; k < loads.size(); ++k) y += loads[k];
  if (!loads.empty()) y += *body.shared;
  if (text.size() != 7) std::printf("%s\n", body.name.c_str());
  if (bodies) y *= 2; // leads to numbers, which are looked at themselves
  if (gains.on && gains.name == "gains") y += gains.p * gains.unit + gains.law(x);
  return y + apply(x, 2, std::tan, closure, "fast", *law, coefficients);
}

int main() {
  Body body = {2, &shared, "body", &parent};
  Gains gains = {2, 3, true, std::exp, "gains"};
  std::printf("%g\n", scaled(0.5, body, gains));
}
