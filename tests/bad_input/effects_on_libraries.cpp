// Changes by a kernel of the state of the C and the C++ library, of its signals, or of a file that was open before,
// is an effect that generated code does not have.
// RUN: rm -rf %t && not %symreal generate %s -o %t/ 2>&1 | FileCheck %s
// RUN: not ls %t
// verify sees it by itself.
// RUN: %symreal generate %s -o %t.c -- -DLATER
// RUN: not %symreal verify %s %t.c --samples=50 -- -DLATER 2>&1 | FileCheck %s --check-prefix=LATER
// LATER: error: kernel 'later': the original sets the seed of rand(), and the generated code does not [SYM215]
// RUN: not %symreal verify %s %t.c --samples=50 -- -DLATER -DSIGNAL 2>&1 | FileCheck %s --check-prefix=SIGNAL
// SIGNAL: error: kernel 'later': the original changes what signal 10 does, and the generated code does not [SYM215]
// A question, a change that is taken back, and a file that the kernel opens and closes do not count.
// RUN: %symreal generate %s -o %t.c -- -DASKS && %symreal verify %s %t.c --samples=50 -- -DASKS
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <locale>
#include <unistd.h>

#if defined(LATER)
#pragma symreal function input(x) output(return)
double later(double x) {
#ifdef MBD_SYMBOLIC
#elif defined(SIGNAL)
  std::signal(SIGUSR1, SIG_IGN);
#else
  std::srand(3);
#endif
  return 2 * x;
}
int main() { return later(0.5) > 5; }

#elif defined(ASKS)
#pragma symreal function input(x) output(return)
double asks(double x) {
  (void)std::setlocale(LC_ALL, nullptr);
  auto *const before = std::signal(SIGUSR1, SIG_IGN);
  std::signal(SIGUSR1, before);
  if (std::FILE *file = std::fopen("/dev/null", "r")) std::fclose(file);
  return 2 * x;
}
int main() { return asks(0.5) > 5; }

#else
static int file;
// CHECK-DAG: :[[@LINE+1]]:1: error: the kernel sets the seed of rand(), and the generated code would not do so [SYM215]
#pragma symreal function input(x) output(return)
double seeds(double x) { return std::srand(3), 2 * x; }
// CHECK-DAG: :[[@LINE+1]]:1: error: the kernel sets the locale,
#pragma symreal function input(x) output(return)
double speaks(double x) { return std::setlocale(LC_ALL, "C"), 2 * x; }
// CHECK-DAG: :[[@LINE+1]]:1: error: the kernel sets the locale,
#pragma symreal function input(x) output(return)
double speaksToo(double x) { return std::locale::global(std::locale::classic()), 2 * x; }
// CHECK-DAG: :[[@LINE+1]]:1: error: the kernel registers a function for the end of the program,
#pragma symreal function input(x) output(return)
double ends(double x) { return std::atexit([] {}), 2 * x; }
// CHECK-DAG: :[[@LINE+1]]:1: error: the kernel sets the handler of std::terminate(),
#pragma symreal function input(x) output(return)
double terminates(double x) { return std::set_terminate(std::abort), 2 * x; }
// CHECK-DAG: :[[@LINE+1]]:1: error: the kernel changes what signal 10 does,
#pragma symreal function input(x) output(return)
double ignores(double x) { return std::signal(SIGUSR1, SIG_IGN), 2 * x; }
// CHECK-DAG: :[[@LINE+1]]:1: error: the kernel sets a timer,
#pragma symreal function input(x) output(return)
double waits(double x) { return alarm(1000), 2 * x; }
// CHECK-DAG: :[[@LINE+1]]:1: error: the kernel closes '{{.*}}',
#pragma symreal function input(x) output(return)
double closes(double x) { return close(file), 2 * x; }

int main() {
  file = dup(0);
  std::printf("%g\n", seeds(0.5) + speaks(0.5) + speaksToo(0.5) + ends(0.5) + terminates(0.5) + ignores(0.5) +
                          waits(0.5) + closes(0.5));
}
#endif
