// Functions of FMI 3.0 that a unit supports, in C.
#pragma once

#include <string_view>

namespace symreal::tool {

inline constexpr std::string_view fmi3_functions = R"(
EXPORTED char const *fmi3GetVersion(void) { return "3.0"; }

EXPORTED fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean on, size_t count,
                                        fmi3String const categories[]) {
  (void)on, (void)count, (void)categories; /* what is said is said in any case */
  return is_allowed(instance, any_state, "fmi3SetDebugLogging") ? fmi3OK : fmi3Error;
}

EXPORTED fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String path,
                                                   fmi3Boolean visible, fmi3Boolean logs,
                                                   fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) {
  (void)name, (void)path, (void)visible, (void)logs;
  return make(token, false, environment, log);
}

EXPORTED fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String path,
                                                  fmi3Boolean visible, fmi3Boolean logs, fmi3Boolean has_events,
                                                  fmi3Boolean returns_early, fmi3ValueReference const required[],
                                                  size_t count, fmi3InstanceEnvironment environment,
                                                  fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback update) {
  (void)name, (void)path, (void)visible, (void)logs, (void)returns_early, (void)required, (void)count, (void)update;
  if (has_events) {
    struct unit said = {.environment = environment, .log = log};
    say(&said, fmi3Error, "fmi3InstantiateCoSimulation: the unit has no events, so eventModeUsed must be false");
    return NULL;
  }
  return make(token, true, environment, log);
}

EXPORTED void fmi3FreeInstance(fmi3Instance instance) { free(instance); }

EXPORTED fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean has_tolerance,
                                                fmi3Float64 tolerance, fmi3Float64 start_time,
                                                fmi3Boolean has_stop, fmi3Float64 stop_time) {
  struct unit *const unit = instance;
  (void)has_tolerance, (void)tolerance;
  if (!is_allowed(unit, instantiated, "fmi3EnterInitializationMode")) return fmi3Error;
  if (!is_finite(start_time) || (has_stop && !(stop_time >= start_time)))
    return say(unit, fmi3Error, "fmi3EnterInitializationMode: the simulation ends before it starts");
  unit->value[0] = start_time;
  unit->end = has_stop ? stop_time : HUGE_VAL;
  unit->at = initialization_mode;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3ExitInitializationMode(fmi3Instance instance) {
  struct unit *const unit = instance;
  if (!is_allowed(unit, initialization_mode, "fmi3ExitInitializationMode")) return fmi3Error;
  unit->at = unit->takes_steps ? step_mode : event_mode;
  return fmi3OK;
}

/* From one of some states to the next. */
#define ENTER(name, states, next)                                   \
  EXPORTED fmi3Status name(fmi3Instance instance) {                 \
    if (!is_allowed(instance, states, #name)) return fmi3Error;     \
    ((struct unit *)instance)->at = next;                           \
    return fmi3OK;                                                  \
  }
ENTER(fmi3EnterEventMode, continuous_time_mode, event_mode)
ENTER(fmi3EnterContinuousTimeMode, event_mode, continuous_time_mode)
ENTER(fmi3Terminate, event_mode | continuous_time_mode | step_mode, terminated)

/* A unit without events and structural parameters. */
EXPORTED fmi3Status fmi3EnterStepMode(fmi3Instance instance) { return refused(instance, "fmi3EnterStepMode"); }
EXPORTED fmi3Status fmi3EnterConfigurationMode(fmi3Instance instance) {
  return refused(instance, "fmi3EnterConfigurationMode");
}
EXPORTED fmi3Status fmi3ExitConfigurationMode(fmi3Instance instance) {
  return refused(instance, "fmi3ExitConfigurationMode");
}
EXPORTED fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance instance) {
  return is_allowed(instance, initialization_mode | event_mode, "fmi3EvaluateDiscreteStates") ? fmi3OK : fmi3Error;
}

EXPORTED fmi3Status fmi3Reset(fmi3Instance instance) {
  if (!is_allowed(instance, any_state, "fmi3Reset")) return fmi3Error;
  reset(instance);
  return fmi3OK;
}

static bool is_state(fmi3ValueReference reference) {
  bool found = false;
  for (size_t k = 0; k < state_count; ++k) found = found || state[k] == reference;
  return found;
}

EXPORTED fmi3Status fmi3GetFloat64(fmi3Instance instance, fmi3ValueReference const references[], size_t count,
                                   fmi3Float64 values[], size_t value_total) {
  struct unit *const unit = instance;
  if (!is_allowed(unit, any_state, "fmi3GetFloat64")) return fmi3Error;
  if (count != value_total) return say(unit, fmi3Error, "each variable has one value");
  for (size_t k = 0; k < count; ++k) {
    if (references[k] >= value_count) return say(unit, fmi3Error, "no variable has this value reference");
    if (references[k] >= at_output) {
      if (!is_allowed(unit, any_state & ~instantiated, "fmi3GetFloat64 of what is calculated")) return fmi3Error;
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
  if (!is_allowed(unit, any_state & ~terminated, "fmi3SetFloat64")) return fmi3Error;
  if (count != value_total) return say(unit, fmi3Error, "each variable has one value");
  for (size_t k = 0; k < count; ++k) {
    if (references[k] < at_input || references[k] >= at_output)
      return say(unit, fmi3Error, "only inputs, states and parameters can be set");
    if (is_state(references[k]) && !is_allowed(unit, instantiated | initialization_mode, "fmi3SetFloat64 of a state"))
      return fmi3Error;
    if (references[k] >= at_parameter &&
        !is_allowed(unit, any_state & ~continuous_time_mode, "fmi3SetFloat64 of a parameter"))
      return fmi3Error;
    unit->value[references[k]] = values[k];
    unit->has_outputs = false;
    if (references[k] >= at_parameter) unit->has_constants = false;
  }
  return fmi3OK;
}

EXPORTED fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean *needs_update, fmi3Boolean *ends,
                                             fmi3Boolean *nominals_changed, fmi3Boolean *states_changed,
                                             fmi3Boolean *has_next_event, fmi3Float64 *next_event) {
  if (!is_allowed(instance, event_mode, "fmi3UpdateDiscreteStates")) return fmi3Error;
  *needs_update = *ends = *nominals_changed = *states_changed = *has_next_event = false;
  *next_event = 0.0;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance, fmi3Boolean keeps, fmi3Boolean *enters_events,
                                                fmi3Boolean *ends) {
  (void)keeps;
  if (!is_allowed(instance, continuous_time_mode, "fmi3CompletedIntegratorStep")) return fmi3Error;
  *enters_events = *ends = false;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64 time) {
  struct unit *const unit = instance;
  if (!is_allowed(unit, event_mode | continuous_time_mode, "fmi3SetTime")) return fmi3Error;
  if (!is_finite(time)) return say(unit, fmi3Error, "fmi3SetTime: the time is not finite");
  unit->value[0] = time;
  return fmi3OK;
}

/* Of model exchange. */
enum { initialized = initialization_mode | event_mode | continuous_time_mode | terminated };

static bool takes_states(struct unit *unit, unsigned states, char const *function, size_t count) {
  if (!is_allowed(unit, states, function)) return false;
  if (unit->takes_steps) return say_of(unit, function, " is for model exchange"), false;
  if (count != state_count) return say(unit, fmi3Error, "the unit has another number of states"), false;
  return true;
}

static void get_states(struct unit const *unit, double states[]) {
  for (size_t k = 0; k < state_count; ++k) states[k] = unit->value[state[k]];
}

static void set_states(struct unit *unit, double const states[]) {
  for (size_t k = 0; k < state_count; ++k) unit->value[state[k]] = states[k];
  unit->has_outputs = false;
}

static fmi3Status get_derivatives(struct unit *unit, double derivatives[]) {
  fmi3Status const status = evaluate(unit);
  for (size_t k = 0; k < state_count && status == fmi3OK; ++k) derivatives[k] = unit->value[derivative[k]];
  return status;
}

EXPORTED fmi3Status fmi3GetContinuousStates(fmi3Instance instance, fmi3Float64 states[], size_t count) {
  if (!takes_states(instance, initialized, "fmi3GetContinuousStates", count)) return fmi3Error;
  get_states(instance, states);
  return fmi3OK;
}

EXPORTED fmi3Status fmi3SetContinuousStates(fmi3Instance instance, fmi3Float64 const states[], size_t count) {
  if (!takes_states(instance, continuous_time_mode, "fmi3SetContinuousStates", count)) return fmi3Error;
  set_states(instance, states);
  return fmi3OK;
}

EXPORTED fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64 derivatives[], size_t count) {
  if (!takes_states(instance, initialized, "fmi3GetContinuousStateDerivatives", count)) return fmi3Error;
  return get_derivatives(instance, derivatives);
}

EXPORTED fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance, fmi3Float64 nominals[], size_t count) {
  if (!takes_states(instance, initialized, "fmi3GetNominalsOfContinuousStates", count)) return fmi3Error;
  for (size_t k = 0; k < count; ++k) nominals[k] = 1.0;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3GetEventIndicators(fmi3Instance instance, fmi3Float64 indicators[], size_t count) {
  (void)indicators;
  if (!is_allowed(instance, initialized, "fmi3GetEventIndicators")) return fmi3Error;
  return count == 0 ? fmi3OK : say(instance, fmi3Error, "the unit has no event indicators");
}

EXPORTED fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, size_t *count) {
  if (!is_allowed(instance, any_state, "fmi3GetNumberOfEventIndicators")) return fmi3Error;
  *count = 0;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, size_t *count) {
  if (!is_allowed(instance, any_state, "fmi3GetNumberOfContinuousStates")) return fmi3Error;
  *count = state_count;
  return fmi3OK;
}
)";

} // namespace symreal::tool
