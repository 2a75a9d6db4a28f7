#include "emit/print/function_plan.h"

#include "emit/print/angles.h"

namespace symreal {

FunctionPlan function_plan(Emission const &emission, FunctionKind kind) {
  Schedule const &plan = emission.plan;
  Rerolled const *const loops = emission.loops;
  switch (kind) {
  case FunctionKind::preprocess:
    return {plan.preprocess,
            loops ? &loops->preprocess : nullptr,
            emission.name("preprocess"),
            {"parameters"},
            "constants",
            false,
            false,
            false};
  case FunctionKind::computed_angles:
    return {plan.angles.computed,
            loops ? &loops->computed_angles : nullptr,
            angles_function(emission),
            {"input", "constants"},
            computed_angles,
            true,
            false,
            true};
  case FunctionKind::compute: break;
  }
  return {plan.compute,
          loops ? &loops->compute : nullptr,
          emission.name("compute"),
          {"input", "constants"},
          "output",
          true,
          plan.angles.size() != 0,
          false};
}

} // namespace symreal
