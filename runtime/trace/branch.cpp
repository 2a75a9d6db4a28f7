// The parts of decisions that record nothing in the user's name.
#include "runtime/memory/own_memory.h"
#include "runtime/trace/decisions/explored_path.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/events.h"
#include "runtime/trace/state/state.h"

#include <symreal/branch.h>
#include <symreal/extremes.h>

#include <deque>

namespace symreal {

List<RealNumber> Targets::values() const {
  List<RealNumber> values;
  values.reserve(numbers_.size());
  for (RealNumber const *number : numbers_) values.push_back(*number);
  return values;
}

List<std::size_t> Targets::foreign() const {
  List<std::size_t> foreign;
  if (!detail::recording) return foreign;
  trace::Pause const pause;
  for (std::size_t k = 0; k < numbers_.size(); ++k)
    if (trace::session().state.is_foreign(numbers_[k])) foreign.push_back(k);
  return foreign;
}

List<bool> Targets::take_written(List<std::size_t> const &foreign) const {
  trace::Pause const pause;
  List<bool> written;
  for (std::size_t k : foreign) written.push_back(trace::session().state.take_written(numbers_[k]));
  return written;
}

void Targets::keep(List<std::size_t> const &foreign, List<bool> const &written_before,
                   List<RealNumber> const &values) const {
  trace::Pause const pause;
  trace::State &state = trace::session().state;
  for (std::size_t k = 0; k < foreign.size(); ++k) {
    RealNumber const *number = numbers_[foreign[k]];
    bool const written = state.take_written(number);
    if (written != written_before[k])
      state.keep(number, values[foreign[k]].plain());
    else if (written)
      state.was_written(number);
  }
}

void Targets::restore(List<RealNumber> const &values) const {
  for (std::size_t k = 0; k < numbers_.size(); ++k) *numbers_[k] = values[k];
}

void Level::has_returned(SymbolicBool condition) {
  rest.end(); // the condition is that of the level's own path
  returned = returned | condition;
  rest.begin(!returned);
}

Returned Returns::symreal_result() {
  body_.rest.end();
  if (!kernel_) return {result_, plain_};
  kernel_->defer_returned(false);
  return {kernel_->deferred(result_), plain_};
}

RealNumber Returns::take_last() {
  internal_check(!noted_.empty()); // a function that ends without `return` has no value in the original either
  RealNumber value = noted_.back().value;
  noted_.pop_back();
  return value;
}

Branch::~Branch() {
  if (returns_ && outer_) returns_->level_ = outer_; // left by an exception
}

void Branch::enter(SymbolicBool condition) {
  path_.begin(condition);
  if (!returns_) return;
  outer_ = returns_->level_;
  level_.path = outer_->path & condition;
  level_.returned = false;
  returns_->level_ = &level_;
}

// The condition, within the arm, under which it returned.
SymbolicBool Branch::leave() {
  level_.rest.end();
  path_.end();
  if (!returns_) return SymbolicBool(false);
  returns_->level_ = outer_;
  outer_ = nullptr;
  return level_.returned;
}

void Branch::begin_then() {
  before_ = targets_.values();
  foreign_ = targets_.foreign();
  enter(condition_);
}

void Branch::begin_else() {
  then_returned_ = leave();
  then_values_ = targets_.values();
  if (!foreign_.empty()) then_written_ = targets_.take_written(foreign_);
  targets_.restore(before_);
  enter(!condition_);
}

void Branch::end_else() {
  else_returned_ = leave();
  if (!returns_) return;
  bool const some = then_returned_.is_symbolic() || else_returned_.is_symbolic() || is_certain(then_returned_) ||
                    is_certain(else_returned_);
  if (!some) return;
  bool const all = is_certain(then_returned_) && is_certain(else_returned_);
  returns_->level_->has_returned(all ? SymbolicBool(true)
                                     : (condition_ & then_returned_) | ((!condition_) & else_returned_));
}

void Loop::narrow(SymbolicBool condition) {
  path_.end();
  active_ = active_ & condition;
  if (active_.is_symbolic()) path_.begin(active_);
}

void Loop::stop() {
  path_.end();
  bool const is_hypothetical = trace::session().path.is_hypothetical();
  bool const goes_on = !active_.is_symbolic() || detail::carried_value(active_.condition()) != 0;
  if (goes_on && (!is_hypothetical || !active_.is_symbolic()))
    trace::report_here(DiagnosticId::loop_exceeded,
                       "the loop is bounded to " + std::to_string(limit_) + " runs and goes on in this run");
  else
    require(!active_);
  active_ = false;
}

RealNumber const &detail::keep(RealNumber x) {
  // The program's memory, which joins compare, not the session's own. A deque keeps its elements in place.
  static thread_local std::deque<RealNumber> kept;
  return kept.emplace_back(x);
}

} // namespace symreal
