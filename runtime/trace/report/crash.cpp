// Report of a signal that ended the program, for the driver (watch_for_crashes).
#include "runtime/trace/report/call_stack.h"
#include "runtime/trace/report/events.h"

#include <csignal>
#include <cstdint>
#include <fcntl.h>
#include <string>
#include <unistd.h>

// The handler allocates nothing: the program may have ended in the middle of malloc.
namespace symreal::trace {
namespace {

constinit char file[4096] = {};

class Writer {
public:
  explicit Writer(int descriptor) : descriptor_(descriptor) {}
  ~Writer() { flush(); }
  Writer(Writer const &) = delete;
  Writer &operator=(Writer const &) = delete;

  void add(char c) {
    if (used_ == sizeof buffer_) flush();
    buffer_[used_++] = c;
  }
  void add(std::uintptr_t value, unsigned base) {
    char digits[24];
    unsigned count = 0;
    do digits[count++] = "0123456789abcdef"[value % base];
    while ((value /= base) != 0);
    while (count != 0) add(digits[--count]);
  }

private:
  void flush() {
    [[maybe_unused]] auto const written = write(descriptor_, buffer_, used_);
    used_ = 0;
  }

  int descriptor_;
  char buffer_[512];
  std::size_t used_ = 0;
};

void on_crash(int number, siginfo_t *, void *) {
  int const descriptor = open(file, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (descriptor >= 0) {
    Writer text(descriptor);
    text.add(static_cast<std::uintptr_t>(number), 10);
    text.add(' ');
    for_each_interrupted([&text](std::uintptr_t address) {
      text.add(address, 16);
      text.add(',');
    });
  }
  std::signal(number, SIG_DFL);
  std::raise(number); // delivered when the handler returns
}

void watch(int number) {
  struct sigaction current;
  if (sigaction(number, nullptr, &current) != 0 || (current.sa_flags & SA_SIGINFO) != 0 ||
      current.sa_handler != SIG_DFL)
    return;
  struct sigaction action = {};
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_RESETHAND;
  action.sa_sigaction = on_crash;
  sigaction(number, &action, nullptr);
}

} // namespace

void watch_for_crashes() {
  static bool is_watching = false;
  std::string const name = record_directory() + "/crash";
  if (is_watching || record_directory().empty() || name.size() >= sizeof file) return;
  is_watching = true;
  name.copy(file, name.size());
  (void)call_stack(); // unwinding allocates at its first use
  constexpr std::size_t stack_size = 1 << 16;
  static char stack[stack_size]; // after an overflow the thread's own is full
  stack_t const alternative = {.ss_sp = stack, .ss_flags = 0, .ss_size = stack_size};
  sigaltstack(&alternative, nullptr);
  for (int number : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}) watch(number);
}

} // namespace symreal::trace

// Before the program's own objects are made.
[[gnu::constructor]] static void begin_to_watch() { symreal::trace::watch_for_crashes(); }
