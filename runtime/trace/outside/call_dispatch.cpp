#include "runtime/trace/outside/call_dispatch.h"

#if defined(__linux__) && defined(__x86_64__)

#include "runtime/memory/heap_blocks.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#ifndef PR_SET_SYSCALL_USER_DISPATCH
#define PR_SET_SYSCALL_USER_DISPATCH 59
#endif

namespace symreal::trace {

namespace {

constexpr char allow = 0, block = 1;
char selector = allow; // which the kernel of the system reads at each system call
struct sigaction previous;
// A stack of the handler's own: its traces would show in comparisons of two processes' stacks (trace/join).
alignas(16) char handler_stack[1 << 16];
stack_t previous_stack;

// The code that returns from a handler, which calls the system itself.
std::uintptr_t restorer() {
  struct {
    void *handler;
    unsigned long flags;
    void *restorer;
    unsigned long mask;
  } action{};
  syscall(SYS_rt_sigaction, SIGSYS, nullptr, &action, sizeof action.mask);
  return reinterpret_cast<std::uintptr_t>(action.restorer);
}

void give_back_handler() {
  sigaction(SIGSYS, &previous, nullptr);
  sigaltstack(&previous_stack, nullptr);
}

} // namespace

bool dispatch() {
  constexpr unsigned long restorer_size = 16;
  return prctl(PR_SET_SYSCALL_USER_DISPATCH, 1, restorer(), restorer_size, &selector) == 0;
}

void set_dispatch(bool is_on) { selector = is_on ? block : allow; }

bool begin_dispatch(CallHandler *handler) {
  stack_t stack = {};
  stack.ss_sp = handler_stack;
  stack.ss_size = sizeof handler_stack;
  sigaltstack(&stack, &previous_stack);
  struct sigaction action = {};
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  action.sa_sigaction = handler;
  sigaction(SIGSYS, &action, &previous);
  bool const has_begun = dispatch();
  if (!has_begun) give_back_handler();
  return has_begun;
}

void end_dispatch() {
  prctl(PR_SET_SYSCALL_USER_DISPATCH, 0, 0, 0, 0);
  give_back_handler();
}

SystemCall call_in(gregset_t const &registers) {
  return {registers[REG_RAX],
          {registers[REG_RDI], registers[REG_RSI], registers[REG_RDX], registers[REG_R10], registers[REG_R8],
           registers[REG_R9]}};
}

long carry_out(long number, long const (&a)[6]) {
  long result = number;
  register long r10 asm("r10") = a[3];
  register long r8 asm("r8") = a[4];
  register long r9 asm("r9") = a[5];
  asm volatile("syscall"
               : "+a"(result)
               : "D"(a[0]), "S"(a[1]), "d"(a[2]), "r"(r10), "r"(r8), "r"(r9)
               : "rcx", "r11", "memory");
  return result;
}

namespace {

// Calls by which the runtime reads a file, and takes memory from the end of the heap.
constexpr long leave_nothing[] = {SYS_openat, SYS_newfstatat, SYS_fstat, SYS_read, SYS_close, SYS_brk};

void refuse_call(int, siginfo_t *, void *context) {
  set_dispatch(false);
  auto &registers = static_cast<ucontext_t *>(context)->uc_mcontext.gregs;
  auto const [number, arguments] = call_in(registers);
  if (!memory::OwnWork::is_going_on() || std::ranges::find(leave_nothing, number) == std::end(leave_nothing)) _exit(0);
  registers[REG_RAX] = carry_out(number, arguments);
  set_dispatch(true);
}

// Whether the program leaves the signal, and the stack for it, to others.
bool is_free() {
  struct sigaction action = {};
  stack_t stack = {};
  sigset_t blocked;
  return sigaction(SIGSYS, nullptr, &action) == 0 && action.sa_handler == SIG_DFL &&
         sigaltstack(nullptr, &stack) == 0 && (stack.ss_flags & SS_DISABLE) != 0 &&
         sigprocmask(SIG_BLOCK, nullptr, &blocked) == 0 && sigismember(&blocked, SIGSYS) == 0;
}

bool is_refusing = false;

} // namespace

bool refuse_calls(bool are_refused) {
  if (!is_refusing && !(is_refusing = is_free() && begin_dispatch(refuse_call))) return false;
  set_dispatch(are_refused);
  return true;
}

} // namespace symreal::trace

#else

bool symreal::trace::refuse_calls(bool) { return false; }

#endif
