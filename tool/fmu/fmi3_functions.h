// The functions of FMI 3.0 that a unit has, in C.
#pragma once

#include <string_view>

namespace symreal::tool {

inline constexpr std::string_view fmi3_functions = R"(
EXPORTED char const *fmi3GetVersion(void) { return "3.0"; }

EXPORTED fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean on, size_t count,
                                        fmi3String const categories[]) {
  (void)instance, (void)on, (void)count, (void)categories; /* what is said is said in any case */
  return fmi3OK;
}

EXPORTED fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String path,
                                                   fmi3Boolean visible, fmi3Boolean logs,
                                                   fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) {
  (void)name, (void)path, (void)visible, (void)logs;
  return make(token, environment, log);
}

EXPORTED fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String path,
                                                  fmi3Boolean visible, fmi3Boolean logs, fmi3Boolean has_events,
                                                  fmi3Boolean returns_early, fmi3ValueReference const required[],
                                                  size_t count, fmi3InstanceEnvironment environment,
                                                  fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback update) {
  (void)name, (void)path, (void)visible, (void)logs, (void)has_events, (void)returns_early, (void)required;
  (void)count, (void)update;
  return make(token, environment, log);
}

EXPORTED void fmi3FreeInstance(fmi3Instance instance) { free(instance); }

EXPORTED fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean has_tolerance,
                                                fmi3Float64 tolerance, fmi3Float64 start_time,
                                                fmi3Boolean has_stop, fmi3Float64 stop_time) {
  (void)has_tolerance, (void)tolerance, (void)has_stop, (void)stop_time;
  ((struct unit *)instance)->value[0] = start_time;
  return fmi3OK;
}

#define NOTHING_TO_DO(name)                     \
  EXPORTED fmi3Status name(fmi3Instance instance) { \
    (void)instance;                             \
    return fmi3OK;                              \
  }
NOTHING_TO_DO(fmi3ExitInitializationMode)
NOTHING_TO_DO(fmi3EnterEventMode)
NOTHING_TO_DO(fmi3EnterContinuousTimeMode)
NOTHING_TO_DO(fmi3EnterStepMode)
NOTHING_TO_DO(fmi3EnterConfigurationMode)
NOTHING_TO_DO(fmi3ExitConfigurationMode)
NOTHING_TO_DO(fmi3EvaluateDiscreteStates)
NOTHING_TO_DO(fmi3Terminate)

EXPORTED fmi3Status fmi3Reset(fmi3Instance instance) {
  reset(instance);
  return fmi3OK;
}

EXPORTED fmi3Status fmi3GetFloat64(fmi3Instance instance, fmi3ValueReference const references[], size_t count,
                                   fmi3Float64 values[], size_t value_total) {
  struct unit *const unit = instance;
  if (count != value_total) return say(unit, fmi3Error, "each variable has one value");
  for (size_t k = 0; k < count; ++k) {
    if (references[k] >= value_count) return say(unit, fmi3Error, "no variable has this value reference");
    if (references[k] >= at_output) {
      fmi3Status const status = evaluate(unit);
      if (status != fmi3OK) return status;
    }
    values[k] = unit->value[references[k]];
  }
  return fmi3OK;
}

EXPORTED fmi3Status fmi3SetFloat64(fmi3Instance instance, fmi3ValueReference const references[], size_t count,
                                   fmi3Float64 const values[], size_t value_total) {
  struct unit *const unit = instance;
  if (count != value_total) return say(unit, fmi3Error, "each variable has one value");
  for (size_t k = 0; k < count; ++k) {
    if (references[k] < at_input || references[k] >= at_output)
      return say(unit, fmi3Error, "only inputs, states and parameters can be set");
    unit->value[references[k]] = values[k];
    unit->has_outputs = false;
    if (references[k] >= at_parameter) unit->has_constants = false;
  }
  return fmi3OK;
}

EXPORTED fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean *needs_update, fmi3Boolean *ends,
                                             fmi3Boolean *nominals_changed, fmi3Boolean *states_changed,
                                             fmi3Boolean *has_next_event, fmi3Float64 *next_event) {
  (void)instance;
  *needs_update = *ends = *nominals_changed = *states_changed = *has_next_event = false;
  *next_event = 0.0;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance, fmi3Boolean keeps, fmi3Boolean *enters_events,
                                                fmi3Boolean *ends) {
  (void)instance, (void)keeps;
  *enters_events = *ends = false;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64 time) {
  ((struct unit *)instance)->value[0] = time;
  return fmi3OK;
}

static fmi3Status require_states(struct unit *unit, size_t count) {
  return count == state_count ? fmi3OK : say(unit, fmi3Error, "the unit has another number of states");
}

EXPORTED fmi3Status fmi3GetContinuousStates(fmi3Instance instance, fmi3Float64 states[], size_t count) {
  struct unit *const unit = instance;
  if (require_states(unit, count) != fmi3OK) return fmi3Error;
  for (size_t k = 0; k < count; ++k) states[k] = unit->value[state[k]];
  return fmi3OK;
}

EXPORTED fmi3Status fmi3SetContinuousStates(fmi3Instance instance, fmi3Float64 const states[], size_t count) {
  struct unit *const unit = instance;
  if (require_states(unit, count) != fmi3OK) return fmi3Error;
  for (size_t k = 0; k < count; ++k) unit->value[state[k]] = states[k];
  unit->has_outputs = false;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64 derivatives[], size_t count) {
  struct unit *const unit = instance;
  if (require_states(unit, count) != fmi3OK) return fmi3Error;
  fmi3Status const status = evaluate(unit);
  if (status != fmi3OK) return status;
  for (size_t k = 0; k < count; ++k) derivatives[k] = unit->value[derivative[k]];
  return fmi3OK;
}

EXPORTED fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance, fmi3Float64 nominals[], size_t count) {
  if (require_states(instance, count) != fmi3OK) return fmi3Error;
  for (size_t k = 0; k < count; ++k) nominals[k] = 1.0;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3GetEventIndicators(fmi3Instance instance, fmi3Float64 indicators[], size_t count) {
  (void)indicators;
  return count == 0 ? fmi3OK : say(instance, fmi3Error, "the unit has no event indicators");
}

EXPORTED fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, size_t *count) {
  (void)instance;
  *count = 0;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, size_t *count) {
  (void)instance;
  *count = state_count;
  return fmi3OK;
}
)";

} // namespace symreal::tool
