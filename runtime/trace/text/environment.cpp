#include "runtime/trace/text/environment.h"

#include "runtime/memory/own_memory.h"
#include "runtime/trace/describe/describe.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/events.h"

#include <symreal/environment.h>

#include <cerrno>
#include <cfenv>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace symreal {

namespace trace {

void Environment::begin() {
  reported_.clear();
  is_error_own_ = false;
  error_at_begin_ = errno;
}

void Environment::error_read(char const *place) {
  RealNumber const setter = pool_.last_to_set_error();
  bool const is_callers = !is_error_own_ && errno == error_at_begin_;
  if ((!setter.is_node() && !is_callers) || !reported_.insert(place).second) return;
  report({DiagnosticId::error_number, written_place(place),
          setter.is_node() ? "errno is read where " + describe(setter) + " may have set it"
                           : "errno is read as the caller of the kernel has left it"});
}

void Environment::used(char const *what, char const *place) {
  if (!reported_.insert(place).second) return;
  report({DiagnosticId::environment_used, written_place(place), "the kernel uses " + std::string(what)});
}

std::string Environment::unusual_modes() {
  bool rounds_to_nearest = std::fegetround() == FE_TONEAREST, has_subnormals = true;
#ifdef __SSE2__
  // Modes of the SSE unit, which does the arithmetic; fegetround asks the x87 unit.
  constexpr unsigned rounding = 0x6000, flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  unsigned const control = _mm_getcsr();
  rounds_to_nearest = rounds_to_nearest && (control & rounding) == 0;
  has_subnormals = (control & (flush_to_zero | denormals_are_zero)) == 0;
#elif defined(__aarch64__)
  constexpr std::uint64_t flush_to_zero = std::uint64_t{1} << 24;
  std::uint64_t control;
  asm volatile("mrs %0, fpcr" : "=r"(control));
  has_subnormals = (control & flush_to_zero) == 0;
#endif
  if (!rounds_to_nearest) return "does not round to nearest";
  return has_subnormals ? "" : "takes subnormal numbers for zero";
}

} // namespace trace

namespace detail {

using trace::Pause;
using trace::session;

void error_read(char const *place) noexcept {
  Pause const pause;
  session().environment.error_read(place);
}

void error_written() noexcept {
  trace::session().pool.forget_error();
  session().environment.error_written();
}

void environment_used(char const *what, char const *place) noexcept {
  Pause const pause;
  session().environment.used(what, place);
}

void may_set_error(RealNumber x) noexcept { trace::session().pool.may_set_error(x); }

} // namespace detail
} // namespace symreal
