#include "engine/plan/plan.h"

#include "engine/plan/schedule/angles.h"

namespace symreal {

Plan in_form(Plan plan, PlanForm const &form) {
  bool const has_angles = plan.schedule.angles.size() != 0;
  bool const needs_blocks = has_angles || plan.loops || plan.lanes || plan.schedule.threads > 1;
  if (form.has_angles && !has_angles)
    plan.schedule = with_angles(std::move(plan.schedule));
  else if (!form.has_blocks && !needs_blocks)
    plan.schedule = schedule(plan.graph(), Nesting::bounded, Arms::computed);
  return plan;
}

} // namespace symreal
