// Values that are no double and that the program can change, of every kind: what the kernel reads of them is baked in.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not="error:"
// RUN: not ls %t.c
// Whatever constant(...) names may stay.
// RUN: %symreal generate %s -o %t.c -- -DNAMED && %symreal verify %s %t.c --samples=50 -- -DNAMED
#include <any>
#include <atomic>
#include <bitset>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

struct Law {
  virtual double of(double x) const { return x; }
  virtual ~Law() = default;
};
struct Twice : Law {
  double of(double x) const override { return 2 * x; }
};
struct Half {
  double of(double x) const { return 0.5 * x; }
};
struct Same {
  double of(double x) const { return x; }
};
double same(double x) { return x; }

// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:14: error: kernel 'scaled' reads 'gain' (2), which is neither input nor parameter [SYM017]
static float gain = 2;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:20: error: kernel 'scaled' reads 'wide' (3), which is neither input nor parameter [SYM017]
static long double wide = 3;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:17: error: kernel 'scaled' reads 'function', which is neither input nor parameter [SYM017]
static double (*function)(double) = same;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:23: error: kernel 'scaled' reads 'method', which is neither input nor parameter [SYM017]
static double (Half::*method)(double) const = &Half::of;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:38: error: kernel 'scaled' reads 'closure', which is neither input nor parameter [SYM017]
static std::function<double(double)> closure = same;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:27: error: kernel 'scaled' reads 'limit', which is neither input nor parameter [SYM017]
static std::optional<int> limit;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:33: error: kernel 'scaled' reads 'shape', which is neither input nor parameter [SYM017]
static std::variant<Half, Same> shape;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:17: error: kernel 'scaled' reads 'whatever', which is neither input nor parameter [SYM017]
static std::any whatever;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:26: error: kernel 'scaled' reads 'flag', which is neither input nor parameter [SYM017]
static std::atomic<bool> flag = true;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:23: error: kernel 'scaled' reads 'bits', which is neither input nor parameter [SYM017]
static std::bitset<4> bits;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:20: error: kernel 'scaled' reads 'name', which is neither input nor parameter [SYM017]
static std::string name = "slow";
static char text[8] = "slow";
static char const *word = "slow";
static double const table[2] = {2, 3};
static double const *entry = table;
static Law *maybe = nullptr;
static std::unique_ptr<Law> law = std::make_unique<Twice>();
static Twice twice;
static Law *plain = &twice;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:28: error: kernel 'scaled' reads 'extras', which is neither input nor parameter [SYM017]
static std::vector<double> extras;
static std::vector<float> floats = {1};

// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:22: error: kernel 'scaled' reads 'tenths', which is neither input nor parameter [SYM017]
static std::set<int> tenths = {1};
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:30: error: kernel 'scaled' reads 'names', which is neither input nor parameter [SYM017]
static std::set<std::string> names = {"a"};
static std::shared_ptr<int> owned;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:27: error: kernel 'scaled' reads 'watched', which is neither input nor parameter [SYM017]
static std::weak_ptr<int> watched;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:34: error: kernel 'scaled' reads 'step', which is neither input nor parameter [SYM017]
static std::chrono::milliseconds step{3};
static float single = 1;
static float const &other_name = single;
template <class T> struct Of {
  static T value;
};
template <class T> T Of<T>::value = 2;
// CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:42: error: kernel 'scaled' reads 'Of<T>::value' (2), which is neither input nor parameter [SYM017]
template <class T> T value_of() { return Of<T>::value; }
struct Link {
  Link *next;
};
static Link last = {nullptr}, *first = &last;
static Law *asked = &twice;

void change() {
  tenths.insert(2), names.insert("b"), owned = std::make_shared<int>(3), watched = owned, step *= 2, single = 4;
  Of<float>::value = 5, first = nullptr, asked = nullptr;
  gain = 3, wide = 4, function = nullptr, method = nullptr, closure = nullptr, limit = 3, shape = Same(), whatever = 3;
  flag = false, bits.set(2), name = "fast", std::strcpy(text, "fast"), word = "fast", entry = table + 1, maybe = &twice;
  law = std::make_unique<Law>(), plain = law.get(), extras.push_back(1), floats[0] = 2;
}

#ifdef NAMED
#pragma symreal function input(x) output(return)                                                                       \
    constant(gain, wide, function, method, closure, limit, shape, whatever, flag, bits, name, text, word, entry,       \
             maybe, law, plain, extras, floats, tenths, names, owned, watched, step, other_name, last, asked)
#else
#pragma symreal function input(x) output(return)
#endif
double scaled(double x) {
  double y = x * gain + static_cast<double>(wide) + function(x) + (Half().*method)(x) + closure(x);
  if (limit) y += *limit;
  y += std::visit([x](auto const &one) { return one.of(x); }, shape);
  if (whatever.has_value()) y += 1;
  if (flag) y += 2;
  if (bits.test(2)) y += 4;
  if (name == "fast") y += 8;
  // CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:19: error: kernel 'scaled' reads 'text', which is neither input nor parameter [SYM017]
  if (std::strcmp(text, "fast") == 0) y += 16;
  // CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:19: error: kernel 'scaled' reads 'word', which is neither input nor parameter [SYM017]
  if (std::strcmp(word, "fast") == 0) y += 32;
  // CHECK-DAG: hidden_scalars.cpp:[[#@LINE+5]]:8: error: kernel 'scaled' reads '*entry' (2), which is neither input nor parameter [SYM017]
  // CHECK-DAG: hidden_scalars.cpp:[[#@LINE+4]]:9: error: kernel 'scaled' reads 'entry', which is neither input nor parameter [SYM017]
  // CHECK-DAG: hidden_scalars.cpp:[[#@LINE+3]]:17: error: kernel 'scaled' reads 'law', which is neither input nor parameter [SYM017]
  // CHECK-DAG: hidden_scalars.cpp:[[#@LINE+2]]:30: error: kernel 'scaled' reads 'plain', which is neither input nor parameter [SYM017]
  // CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:82: error: kernel 'scaled' reads 'floats' (1), which is neither input nor parameter [SYM017]
  y += *entry + law->of(x) + plain->of(x) + static_cast<double>(extras.size()) + floats[0];
  // CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:28: error: kernel 'scaled' reads 'tenths' (1), which is neither input nor parameter [SYM017]
  y += static_cast<double>(tenths.count(2));
  y += static_cast<double>(names.count("b"));
  // CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:7: error: kernel 'scaled' reads 'owned', which is neither input nor parameter [SYM017]
  if (owned) y += 1;
  if (watched.expired()) y += 2;
  y += static_cast<double>(step.count());
#ifndef NAMED // a pragma cannot name it
  y += value_of<float>();
#endif
  // CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:8: error: kernel 'scaled' reads 'other_name' (1), which is neither input nor parameter [SYM017]
  y += other_name;
  // CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:55: error: kernel 'scaled' reads 'one->next', which is neither input nor parameter [SYM017]
  for (Link const *one = first; one != nullptr; one = one->next) y += 1;
  // CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:29: error: kernel 'scaled' reads 'asked', which is neither input nor parameter [SYM017]
  if (dynamic_cast<Twice *>(asked)) y += 2;
  // CHECK-DAG: hidden_scalars.cpp:[[#@LINE+1]]:10: error: kernel 'scaled' reads 'maybe', which is neither input nor parameter [SYM017]
  return maybe ? y + 1 : y;
}

int main(int count, char **) {
  if (count > 5) change();
  std::printf("%g\n", scaled(0.5));
}
