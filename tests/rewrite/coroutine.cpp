// A call of a coroutine, which runs on when somebody resumes it, is no part of a select.
// RUN: %rewrite --refusals %s -- -std=c++20 | FileCheck %s
#include <coroutine>

struct Steps {
  struct promise_type {
    Steps get_return_object() { return {}; }
    std::suspend_never initial_suspend() noexcept { return {}; }
    std::suspend_never final_suspend() noexcept { return {}; }
    void return_void() {}
    void unhandled_exception() {}
  };
};
Steps halve(double *x) {
  *x = *x / 2;
  co_return;
}
double limited(double x) {
  // CHECK: coroutine.cpp:[[@LINE+1]]:7 {{.*}} a call of 'halve', which has a coroutine ({{.*}}:[[@LINE-5]]:24) at {{.*}}:[[@LINE+1]]:14
  if (x > 4) halve(&x);
  return x;
}
