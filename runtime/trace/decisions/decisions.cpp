// Branches and conversions of symbolic values, which leave the real numbers. The program goes on with the carried
// value. By policy the outcome becomes a guard of the kernel, or the place is reported and the driver makes an error of
// it, so that nothing is baked in silently.
#include "runtime/trace/decisions/decisions.h"

#include "engine/graph/graph.h"
#include "engine/ops/operation.h"
#include "engine/support/number.h"
#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/decisions/explored_path.h"
#include "runtime/trace/decisions/guards.h"
#include "runtime/trace/describe/describe.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/events.h"
#include "runtime/trace/state/state.h"
#include "runtime/wire/request.h"

#include <symreal/symbolic_int.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace symreal {

using trace::Conditions;
using trace::session;

static Decisions program_policy() {
  static Decisions const policy = [] {
    char const *text = wire::requested(wire::Entry::decisions);
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
  int const policy = session().conditions.policy;
  return policy == Conditions::as_the_program ? program_policy() : static_cast<Decisions>(policy);
}

bool detail::selects() noexcept {
  Decisions const policy = decisions();
  return policy == Decisions::select || policy == Decisions::best;
}

DecisionScope::DecisionScope(Decisions policy) noexcept
    : before_(std::exchange(session().conditions.policy, static_cast<int>(policy))) {}
DecisionScope::~DecisionScope() { session().conditions.policy = before_; }

ExactScope::ExactScope() noexcept : before_(session().pool.set_exact(true)) {}
ExactScope::~ExactScope() { session().pool.set_exact(before_); }

PathScope::PathScope(SymbolicBool condition) noexcept : before_(session().conditions.path) {
  session().conditions.path = (SymbolicBool::from_condition(before_) & condition).condition();
}
PathScope::~PathScope() { session().conditions.path = before_; }

void require(SymbolicBool condition) noexcept { session().guards.add(condition, true); }

namespace trace {

FloatingPoint floating_point() {
  static FloatingPoint const mode = [] {
    char const *text = wire::requested(wire::Entry::fp);
    return (text ? parse_floating_point(text) : std::nullopt).value_or(FloatingPoint::finite);
  }();
  return mode;
}

} // namespace trace

namespace detail {

using trace::Pool;

static void require_value(double value, std::string const &what) {
  if (!trace::is_missing(value)) return;
  trace::report_here(DiagnosticId::missing_value, what + " depends on an input that has no value");
  trace::give_up();
}

double needed_value(RealNumber x) noexcept {
  memory::OwnWork const own;
  double value = session().pool.carried_value(x);
  if (trace::is_missing(value)) require_value(value, "the value of " + trace::describe(x));
  return value;
}

// Whether the node may be an infinite or NaN constant passed on. The search is bounded: true if it is cut short.
static bool may_be_own_infinity(NodeId node) {
  NodeTable const &nodes = session().pool.nodes();
  constexpr std::size_t most = 1000;
  std::vector<NodeId> seen = {node};
  for (std::size_t k = 0; k < seen.size(); ++k) {
    Node const &one = nodes[seen[k]];
    if (one.is_constant() && !std::isfinite(one.value())) return true;
    if (is_leaf(one.op) || !hands_on(one.op)) continue;
    for (NodeId operand : one.operand)
      if (operand != no_node && std::find(seen.begin(), seen.end(), operand) == seen.end()) seen.push_back(operand);
    if (seen.size() > most) return true;
  }
  return false;
}

// Premise P1 of mode finite: every value that is computed is finite. A program whose own values are not is outside of
// it and decides.
static bool is_settled(RealNumber x) {
  if (trace::floating_point() == FloatingPoint::strict) return false;
  double value = session().pool.carried_value(x);
  return trace::is_missing(value) || std::isfinite(value);
}

RealNumber compare(Op op, RealNumber x, RealNumber y) noexcept {
  if (x.to_bits() == y.to_bits() && is_settled(x)) {
    memory::OwnWork const own;
    trace::report_settled(trace::describe(op, x, y));
    return RealNumber(evaluate(op, 0, 0, 0));
  }
  return session().pool.record(op, x, y, 0.0, __builtin_return_address(0));
}

RealNumber compare_finite(RealNumber x) noexcept {
  if (is_settled(x) && !may_be_own_infinity(session().pool.node(x))) {
    memory::OwnWork const own;
    trace::report_settled("isfinite(" + trace::describe(x) + ")");
    return 1.0;
  }
  void const *caller = __builtin_return_address(0);
  Pool &pool = session().pool;
  RealNumber magnitude = pool.record(Op::abs, x, 0.0, 0.0, caller);
  return pool.record(Op::le, magnitude, std::numeric_limits<double>::max(), 0.0, caller);
}

static void report(std::string const &decision) {
  if (decisions() == Decisions::carry)
    trace::report_carried(decision);
  else
    trace::report_decision(decision);
  // A hypothetical path must not go on with a value that the program cannot have here.
  if (session().path.is_hypothetical()) trace::give_up();
}

static bool decide_at(trace::Stand &stand) {
  memory::OwnWork const own;
  RealNumber const condition = RealNumber::from_bits(stand.condition);
  double const value = session().pool.carried_value(condition);
  if (trace::is_missing(value)) require_value(value, "the decision on " + trace::describe(condition));
  session().state.decided();
  if (decisions() == Decisions::explore || decisions() == Decisions::best) return session().path.decide(stand);
  if (decisions() == Decisions::guard)
    session().guards.add(SymbolicBool::from_condition(condition), value != 0);
  else
    report(trace::describe(condition));
  return value != 0;
}

// Whether a conversion becomes a guard: it has too many outcomes for a path each.
static bool is_guarded() { return decisions() == Decisions::guard || decisions() == Decisions::best; }

static std::string conversion(RealNumber x) { return "the conversion of " + trace::describe(x); }

double convert_to_integer(RealNumber x) noexcept {
  memory::OwnWork const own;
  double value = needed_value(x);
  session().state.decided();
  if (is_guarded())
    session().guards.add(trunc(x) == RealNumber(std::trunc(value)),
                         conversion(x) + std::string(guard_gives) + shortest(std::trunc(value)));
  else
    report(conversion(x));
  return value;
}

std::uint64_t convert_wide(RealNumber integer) noexcept {
  memory::OwnWork const own;
  double const value = needed_value(integer);
  session().state.decided();
  if (is_guarded())
    session().guards.add(wide_equal(integer64_of_bits(integer), integer64(bits(value))),
                         conversion(integer) + std::string(guard_gives) +
                             std::to_string(static_cast<std::int64_t>(bits(value))));
  else
    report(conversion(integer));
  return bits(value);
}

double value_of_exponent(RealNumber x) noexcept {
  memory::OwnWork const own;
  double const value = needed_value(x);
  session().state.decided();
  std::string const name = "the exponent of " + trace::describe(x);
  if (!is_guarded() || (value != 0 && !std::isnormal(value))) {
    report(name);
    return value;
  }
  if (value == 0) {
    session().guards.add(x == RealNumber(0.0), true);
    return value;
  }
  RealNumber const magnitude = abs(x);
  double const least = std::ldexp(1.0, std::ilogb(value)), beyond = 2 * least;
  session().guards.add((magnitude >= RealNumber(least)) & (magnitude <= RealNumber(std::nextafter(beyond, 0.0))),
                       name + std::string(guard_gives) + std::to_string(std::ilogb(value)));
  return value;
}

double convert(RealNumber x) noexcept {
  memory::OwnWork const own;
  double value = needed_value(x);
  report(conversion(x));
  return value;
}

} // namespace detail
} // namespace symreal

// C++ half of decide_on (trace/decisions/stand.cpp).
extern "C" bool symreal_decide_at(symreal::trace::Stand *stand) noexcept { return symreal::detail::decide_at(*stand); }
