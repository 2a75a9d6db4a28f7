#include "runtime/trace/decisions/policy.h"

#include "runtime/trace/decisions/explored_path.h"
#include "runtime/trace/decisions/guards.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/events.h"

#include <cstdlib>
#include <cstring>

namespace symreal {

static constexpr int as_the_program = -1;
static __thread int scoped_policy = as_the_program;
static constinit thread_local RealNumber path{1.0}, arm{1.0};

static Decisions program_policy() {
  static Decisions const policy = [] {
    char const *text = std::getenv("SYMREAL_DECISIONS");
    if (text && std::strcmp(text, "guard") == 0) return Decisions::guard;
    if (text && std::strcmp(text, "select") == 0) return Decisions::select;
    bool const is_best = text && std::strcmp(text, "auto") == 0;
    if (is_best || (text && std::strcmp(text, "explore") == 0)) {
      if (trace::ExploredPath::is_asked_for()) return is_best ? Decisions::best : Decisions::explore;
      trace::report(
          {DiagnosticId::explore_by_hand, {}, "one run of a program explores nothing: each decision is an error"});
    }
    return Decisions::error;
  }();
  return policy;
}

Decisions decisions() noexcept {
  return scoped_policy == as_the_program ? program_policy() : static_cast<Decisions>(scoped_policy);
}

bool detail::selects() noexcept {
  Decisions const policy = decisions();
  return policy == Decisions::select || policy == Decisions::best;
}

DecisionScope::DecisionScope(Decisions policy) noexcept : before_(scoped_policy) {
  scoped_policy = static_cast<int>(policy);
}
DecisionScope::~DecisionScope() { scoped_policy = before_; }

ExactScope::ExactScope() noexcept : before_(trace::Pool::current().set_exact(true)) {}
ExactScope::~ExactScope() { trace::Pool::current().set_exact(before_); }

PathScope::PathScope(SymbolicBool condition) noexcept : before_(path) {
  path = (SymbolicBool::from_condition(path) & condition).condition();
}
PathScope::~PathScope() { path = before_; }

void require(SymbolicBool condition) noexcept { trace::Guards::current().add(condition, true); }

namespace trace {

RealNumber current_path() { return path; }
void set_arm(RealNumber condition) { arm = condition; }
RealNumber current_arm() { return arm; }

FloatingPoint floating_point() {
  static FloatingPoint const mode = [] {
    char const *text = std::getenv("SYMREAL_FP");
    return (text ? parse_floating_point(text) : std::nullopt).value_or(FloatingPoint::finite);
  }();
  return mode;
}

} // namespace trace
} // namespace symreal
