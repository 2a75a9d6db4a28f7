#include "tool/commands/planned_code.h"

#include "engine/emit/emit.h"
#include "engine/plan/schedule/angles.h"

#include <algorithm>

namespace symreal::tool {

std::vector<LanguagePlan> PlannedCode::of(PlanRequest const &request) const {
  std::vector<LanguagePlan> all;
  for (Language const *language : request.languages)
    all.push_back({language, &plans.at(form_of(*language, request.wishes_angles()))});
  return all;
}

Plan with_wished_angles(Plan const &plan, EmitterOptions const &options, FloatingPoint mode,
                        std::vector<Language const *> const &languages) {
  bool const any = std::ranges::any_of(languages, [](Language const *one) { return one->angles.is_given(); });
  return any && options.has_angles(mode) ? with_angles(plan) : plan;
}

PlannedCode planned_code(Plan const &schedule, std::optional<Rerolled> const &found, PlanRequest const &request) {
  PlannedCode result;
  Plan const laid_out =
      with_wished_angles(schedule, request.emitter, request.passes.floating_point(), request.languages);
  result.angles = describe(laid_out.angles);
  std::optional<Rerolled> const loops =
      request.reroll.loops(laid_out, found, request.passes, result.remarks, result.loops);
  if (loops && loops->functions.contains(FunctionKind::compute)) result.looped = executed_operations(laid_out, *loops);
  std::optional<Laned> const lanes = request.vector.lanes(laid_out, result.remarks, result.lanes);
  result.common.has_angles = request.wishes_angles();
  auto const with = [&](Plan plan) {
    if (loops) plan = with_loops(std::move(plan), *loops);
    if (lanes) plan.compute().lanes = lanes->compute;
    return plan;
  };
  auto const add = [&](PlanForm const &form) {
    if (!result.plans.contains(form))
      result.plans.emplace(form, in_form(with(form.has_angles ? laid_out : schedule), form));
  };
  for (Language const *language : request.languages) {
    add(form_of(*language, request.wishes_angles()));
    result.common.has_angles = result.common.has_angles && language->angles.is_given();
  }
  add(result.common);
  return result;
}

PlannedCode planned_code(Plan const &plan, PlanRequest const &request) {
  PlannedCode result;
  result.plans.emplace(result.common, plan);
  for (Language const *language : request.languages) {
    PlanForm const form = form_of(*language, request.wishes_angles());
    if (!result.plans.contains(form)) result.plans.emplace(form, in_form(plan, form));
  }
  return result;
}

} // namespace symreal::tool
