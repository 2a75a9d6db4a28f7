// Where a program leaves the real numbers: branches and conversions. The program goes on with its carried value; the
// place is reported, and the driver makes an error of it, so that nothing is baked in silently.
#include "trace/describe.h"
#include "trace/events.h"
#include "trace/pool.h"

namespace symreal::detail {

using trace::Pool;

static void require_value(double value, std::string const &what) {
  if (!trace::is_missing(value)) return;
  trace::report_here(DiagnosticId::missing_value, what + " depends on an input that has no value");
  trace::give_up();
}

bool decide(Op op, RealNumber x, RealNumber y, bool outcome) noexcept {
  std::string condition = trace::describe(op, x, y);
  Pool &pool = Pool::current();
  require_value(pool.carried_value(x), "the decision on " + condition);
  require_value(pool.carried_value(y), "the decision on " + condition);
  trace::report_decision(condition);
  return outcome;
}

double needed_value(RealNumber x) noexcept {
  double value = Pool::current().carried_value(x);
  if (trace::is_missing(value)) require_value(value, "the value of " + trace::describe(x));
  return value;
}

double convert(RealNumber x) noexcept {
  double value = needed_value(x);
  trace::report_decision("the conversion of " + trace::describe(x));
  return value;
}

} // namespace symreal::detail
