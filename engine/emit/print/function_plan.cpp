#include "engine/emit/print/function_plan.h"

#include "engine/emit/print/angles.h"

namespace symreal {

FunctionPlan function_plan(Emission const &emission, FunctionKind kind) {
  Schedule const &plan = emission.plan;
  Rerolled const *const loops = emission.loops;
  if (kind == FunctionKind::preprocess) {
    std::vector<std::string> const inputs = {"parameters"};
    return {plan.preprocess,
            loops ? &loops->preprocess : nullptr,
            emission.name("preprocess"),
            inputs,
            inputs,
            "constants",
            false,
            false};
  }
  std::vector<std::string> const inputs = {"input", "constants"};
  if (kind == FunctionKind::computed_angles)
    return {plan.angles.computed,
            loops ? &loops->computed_angles : nullptr,
            angles_function(emission),
            inputs,
            inputs,
            computed_angles,
            true,
            true};
  std::vector<std::string> part_inputs = inputs;
  if (plan.angles.size() != 0)
    for (Array const array : {Array::sine, Array::cosine}) part_inputs.emplace_back(name_of(array));
  return {plan.compute,
          loops ? &loops->compute : nullptr,
          emission.name("compute"),
          inputs,
          std::move(part_inputs),
          "output",
          true,
          false};
}

} // namespace symreal
