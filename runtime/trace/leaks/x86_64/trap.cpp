#include "runtime/trace/leaks/trap.h"

#include "runtime/trace/describe/describe.h"
#include "runtime/trace/leaks/x86_64/saved_state.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/events.h"

#include <bit>
#include <cerrno>
#include <cfenv>
#include <cmath>
#include <csignal>
#include <dlfcn.h>
#include <mutex>
#include <xmmintrin.h>

// Synchronous signal handlers: a handler is called at the faulting instruction, in the middle of the program's own
// computation: it may allocate memory and take locks as any function called there may. While it runs, Linux has every
// floating-point exception masked.
namespace symreal::trace {

using namespace x86_64;

namespace {

// " in libx.so", where an instruction does not belong to the program itself.
std::string in_library(std::uintptr_t instruction) {
  Dl_info file{}, own{};
  bool const known = dladdr(reinterpret_cast<void *>(instruction), &file) != 0 &&
                     dladdr(reinterpret_cast<void *>(&in_library), &own) != 0;
  if (!known || file.dli_fbase == own.dli_fbase) return "";
  std::string const path = file.dli_fname;
  return " in " + path.substr(path.rfind('/') + 1);
}

// Symbolic values among the operands of an instruction of code that was not rewritten.
class Leak {
public:
  // Whether these bits are a node of this recording.
  bool meet(std::uint64_t bits) {
    is_torn_ |= Pool::is_torn(RealNumber::from_bits(bits));
    if (!Pool::is_tagged(bits)) return false;
    RealNumber const node = Pool::underlying(bits);
    if (!session().pool.owns(node)) {
      is_stale_ = true;
      return false;
    }
    std::string const text = describe(node);
    if (values_.find(text) == values_.npos) values_ += (values_.empty() ? "" : " and ") + text;
    return true;
  }
  bool is_any() const { return is_torn_ || is_stale_ || !values_.empty(); }
  // If there are any. The place is where the program stands; `delayed`: as in interrupted_stack.
  void report(std::uintptr_t instruction, std::uintptr_t delayed = 0) const {
    if (!is_any()) return;
    std::string const computes = "code that was not rewritten" + in_library(instruction) + " computes with ";
    if (values_.empty() && is_torn_)
      report_interrupted(DiagnosticId::torn_number, computes + "a number of which a part was overwritten", delayed);
    else if (values_.empty())
      report_interrupted(DiagnosticId::stale_value, computes + "a value of another kernel or thread", delayed);
    else
      report_interrupted(DiagnosticId::leak, computes + values_, delayed);
  }

  // The bits of the carried value of a node that was met.
  static std::uint64_t value(std::uint64_t bits) {
    double const value = session().pool.final_value(Pool::underlying(bits));
    // A missing sign bit means fabs or a negation; fabs comes before comparisons, which decide the path.
    return std::bit_cast<std::uint64_t>(bits >> 63 != 0 ? value : std::fabs(value));
  }

private:
  std::string values_;
  bool is_stale_ = false; // a node of another recording
  bool is_torn_ = false;  // a node with overwritten bytes
};

// Not parts of the session: the handlers run in threads that have none as well.
constinit thread_local bool is_enabled = false;
constinit thread_local bool program_unmasked = false; // it wanted SIGFPE before the kernel began
constinit thread_local bool was_raised = false;       // before the kernel began
constinit thread_local MaskedStep step;

std::mutex installation;
unsigned users = 0; // threads that record
struct sigaction previous_fpe, previous_trap;

// Handles a signal as the program, or the system, would have done.
void pass_on(int number, siginfo_t *info, void *context) {
  struct sigaction const &action = number == SIGFPE ? previous_fpe : previous_trap;
  if ((action.sa_flags & SA_SIGINFO) != 0) {
    action.sa_sigaction(number, info, context);
  } else if (action.sa_handler == SIG_DFL) {
    std::signal(number, SIG_DFL);
    std::raise(number); // delivered when the handler returns
  } else if (action.sa_handler != SIG_IGN) {
    action.sa_handler(number);
  } else if (info->si_code > 0) { // an exception cannot be ignored
    std::signal(number, SIG_DFL);
  }
}

// Puts the carried values in the place of nodes among the operands, and reports them. Whether there are any.
bool examine(SavedState &state) {
  auto const *code = reinterpret_cast<std::uint8_t const *>(state.instruction());
  std::optional<Instruction> const instruction = decode(code, state.address_registers());
  if (!instruction) {
    report_interrupted(DiagnosticId::leak,
                       "an instruction that Symreal cannot read computes with what may be symbolic");
    return true;
  }
  Leak leak;
  for (Operand const &operand : instruction->sources)
    for (unsigned i = 0; i < operand.lanes; ++i) {
      std::uint64_t *place = MaskedStep::place(state, operand, i);
      if (place && leak.meet(*place)) step.substitute(*instruction, operand, i, place, Leak::value(*place));
    }
  leak.report(state.instruction());
  return leak.is_any();
}

bool complete_x87(SavedState &state) {
  PendingOperation operation(state);
  Leak leak;
  std::uint64_t const *operand = operation.operand();
  std::optional<std::uint64_t> substitute;
  if (operand && leak.meet(*operand)) substitute = Leak::value(*operand);
  leak.report(operation.instruction(), operation.instruction());
  if (!leak.is_any() && program_unmasked) return false;
  operation.complete(substitute ? &*substitute : nullptr);
  if (!is_enabled) state.fpu().cwd |= x87_invalid_mask;
  return true;
}

void on_exception(int number, siginfo_t *info, void *context) {
  int const saved_errno = errno;
  SavedState state(context);
  if (step.is_pending()) step.finish(state, is_enabled); // another exception of the same instruction
  bool handled = false;
  if (info->si_code == FPE_FLTINV && state.is_x87()) {
    handled = complete_x87(state);
  } else if (info->si_code == FPE_FLTINV) {
    handled = examine(state) || !program_unmasked;
    if (handled) step.begin(state);
  }
  if (!handled) pass_on(number, info, context);
  errno = saved_errno;
}

void on_step(int number, siginfo_t *info, void *context) {
  SavedState state(context);
  if (step.is_pending())
    step.finish(state, is_enabled); // a thread that the recording one started inherited the exception, and goes without
  else
    pass_on(number, info, context);
}

using Handler = void (*)(int, siginfo_t *, void *);

void install(int number, Handler handler, struct sigaction &previous) {
  struct sigaction action = {};
  action.sa_flags = SA_SIGINFO;
  action.sa_sigaction = handler;
  sigaction(number, &action, &previous);
}

// False where the program has a handler of its own by now, which stays.
bool uninstall(int number, Handler handler, struct sigaction const &previous) {
  struct sigaction current;
  sigaction(number, nullptr, &current);
  if (current.sa_sigaction != handler) return false;
  sigaction(number, &previous, nullptr);
  return true;
}

bool set_masks(bool masked) {
  unsigned const mxcsr = _mm_getcsr();
  std::uint16_t control;
  asm volatile("fnstcw %0" : "=m"(control));
  bool const was_masked = (mxcsr & mxcsr_invalid_mask) != 0;
  control = static_cast<std::uint16_t>(masked ? control | x87_invalid_mask : control & ~x87_invalid_mask);
  _mm_setcsr(masked ? mxcsr | mxcsr_invalid_mask : mxcsr & ~mxcsr_invalid_mask);
  asm volatile("fldcw %0" : : "m"(control));
  return was_masked;
}

} // namespace

void enable_trap() {
  internal_check(!is_enabled);
  std::scoped_lock const lock(installation);
  if (users++ == 0) {
    install(SIGFPE, on_exception, previous_fpe);
    install(SIGTRAP, on_step, previous_trap);
  }
  // Unmasking would signal an exception that the x87 unit has raised before.
  was_raised = std::fetestexcept(FE_INVALID) != 0;
  std::feclearexcept(FE_INVALID);
  is_enabled = true;
  program_unmasked = !set_masks(false);
}

bool disable_trap() {
  if (!is_enabled) return true;
  asm volatile("fwait"); // delivers a pending exception of the x87 unit
  bool in_force = !set_masks(!program_unmasked);
  is_enabled = false;
  if (was_raised) _mm_setcsr(_mm_getcsr() | invalid_flag);
  std::scoped_lock const lock(installation);
  if (--users != 0) return in_force;
  bool const had_exceptions = uninstall(SIGFPE, on_exception, previous_fpe);
  bool const had_steps = uninstall(SIGTRAP, on_step, previous_trap);
  return in_force && had_exceptions && had_steps;
}

} // namespace symreal::trace
