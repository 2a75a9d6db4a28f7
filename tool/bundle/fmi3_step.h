// Co-simulation, copies of an instance, and the functions that a unit does not support, in C.
#pragma once

#include <string_view>

namespace symreal::tool {

inline constexpr std::string_view fmi3_step = R"(
/* One step of the classical Runge-Kutta method; inputs hold their values. A step that fails leaves the states. */
EXPORTED fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 time, fmi3Float64 step, fmi3Boolean keeps,
                               fmi3Boolean *needs_events, fmi3Boolean *ends, fmi3Boolean *returned_early,
                               fmi3Float64 *last_time) {
  struct unit *const unit = instance;
  static double const part[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0, 2.0, 2.0, 1.0};
  double begin[state_count], sum[state_count] = {0.0}, slope[state_count] = {0.0};
  (void)keeps;
  if (!is_allowed(unit, step_mode, "fmi3DoStep")) return fmi3Error;
  double const now = unit->value[0], late = time - now;
  if (!(late <= rounding(now) && -late <= rounding(now)))
    return say(unit, fmi3Error, "fmi3DoStep: a step begins at the time where the last one ended");
  if (!(step > 0.0) || !is_finite(step)) return say(unit, fmi3Error, "fmi3DoStep: the step size must be positive");
  if (time + step > unit->end + rounding(unit->end))
    return say(unit, fmi3Error, "fmi3DoStep: the step goes beyond the stop time");
  *needs_events = *ends = *returned_early = false;
  *last_time = time;
  get_states(unit, begin);
  for (int stage = 0; stage < 4; ++stage) {
    for (int k = 0; k < state_count; ++k) unit->value[state[k]] = begin[k] + part[stage] * step * slope[k];
    unit->has_outputs = false;
    fmi3Status const status = get_derivatives(unit, slope);
    if (status != fmi3OK) {
      set_states(unit, begin);
      return status;
    }
    for (int k = 0; k < state_count; ++k) sum[k] += weight[stage] * slope[k];
  }
  for (int k = 0; k < state_count; ++k) unit->value[state[k]] = begin[k] + step / 6.0 * sum[k];
  unit->has_outputs = false;
  unit->value[0] = *last_time = time + step;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState *copy) {
  if (!is_allowed(instance, any_state, "fmi3GetFMUState")) return fmi3Error;
  if (!*copy) *copy = malloc(sizeof(struct unit));
  if (!*copy) return say(instance, fmi3Error, "no memory");
  memcpy(*copy, instance, sizeof(struct unit));
  return fmi3OK;
}

EXPORTED fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState copy) {
  if (!is_allowed(instance, any_state, "fmi3SetFMUState")) return fmi3Error;
  if (!copy) return say(instance, fmi3Error, "fmi3SetFMUState: there is no state");
  struct unit const *const from = copy;
  struct unit *const unit = instance;
  struct unit const own = *unit;
  *unit = *from;
  unit->environment = own.environment, unit->log = own.log, unit->takes_steps = own.takes_steps;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState *copy) {
  (void)instance;
  free(*copy);
  *copy = NULL;
  return fmi3OK;
}
)";

inline constexpr std::string_view fmi3_refused = R"(
/* No variable has one of these types. */
#define NO_VARIABLES(Type)                                                                                         \
  EXPORTED fmi3Status fmi3Get##Type(fmi3Instance instance, fmi3ValueReference const references[], size_t count,    \
                                    fmi3##Type values[], size_t value_total) {                                     \
    (void)references, (void)values, (void)value_total;                                                             \
    return count == 0 ? fmi3OK : refused(instance, "fmi3Get" #Type);                                               \
  }                                                                                                                \
  EXPORTED fmi3Status fmi3Set##Type(fmi3Instance instance, fmi3ValueReference const references[], size_t count,    \
                                    fmi3##Type const values[], size_t value_total) {                               \
    (void)references, (void)values, (void)value_total;                                                             \
    return count == 0 ? fmi3OK : refused(instance, "fmi3Set" #Type);                                               \
  }
NO_VARIABLES(Float32)
NO_VARIABLES(Int8)
NO_VARIABLES(UInt8)
NO_VARIABLES(Int16)
NO_VARIABLES(UInt16)
NO_VARIABLES(Int32)
NO_VARIABLES(UInt32)
NO_VARIABLES(Int64)
NO_VARIABLES(UInt64)
NO_VARIABLES(Boolean)
NO_VARIABLES(String)

#define REFUSED(name, ...) \
  EXPORTED fmi3Status name(fmi3Instance instance, __VA_ARGS__) { return refused(instance, #name); }
#if defined __GNUC__
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
typedef fmi3ValueReference const *references;
REFUSED(fmi3GetBinary, references r, size_t n, size_t *sizes, fmi3Binary *values, size_t m)
REFUSED(fmi3SetBinary, references r, size_t n, size_t const *sizes, fmi3Binary const *values, size_t m)
REFUSED(fmi3GetClock, references r, size_t n, fmi3Clock *values)
REFUSED(fmi3SetClock, references r, size_t n, fmi3Clock const *values)
REFUSED(fmi3GetNumberOfVariableDependencies, fmi3ValueReference r, size_t *n)
REFUSED(fmi3GetVariableDependencies, fmi3ValueReference r, size_t *of, fmi3ValueReference *on, size_t *at,
        fmi3DependencyKind *kinds, size_t n)
REFUSED(fmi3SerializedFMUStateSize, fmi3FMUState copy, size_t *size)
REFUSED(fmi3SerializeFMUState, fmi3FMUState copy, fmi3Byte *bytes, size_t size)
REFUSED(fmi3DeserializeFMUState, fmi3Byte const *bytes, size_t size, fmi3FMUState *copy)
REFUSED(fmi3GetDirectionalDerivative, references u, size_t n, references k, size_t m, fmi3Float64 const *seed,
        size_t s, fmi3Float64 *sensitivity, size_t t)
REFUSED(fmi3GetAdjointDerivative, references u, size_t n, references k, size_t m, fmi3Float64 const *seed, size_t s,
        fmi3Float64 *sensitivity, size_t t)
REFUSED(fmi3GetIntervalDecimal, references r, size_t n, fmi3Float64 *intervals, fmi3IntervalQualifier *kinds)
REFUSED(fmi3GetIntervalFraction, references r, size_t n, fmi3UInt64 *counters, fmi3UInt64 *resolutions,
        fmi3IntervalQualifier *kinds)
REFUSED(fmi3GetShiftDecimal, references r, size_t n, fmi3Float64 *shifts)
REFUSED(fmi3GetShiftFraction, references r, size_t n, fmi3UInt64 *counters, fmi3UInt64 *resolutions)
REFUSED(fmi3SetIntervalDecimal, references r, size_t n, fmi3Float64 const *intervals)
REFUSED(fmi3SetIntervalFraction, references r, size_t n, fmi3UInt64 const *counters, fmi3UInt64 const *resolutions)
REFUSED(fmi3SetShiftDecimal, references r, size_t n, fmi3Float64 const *shifts)
REFUSED(fmi3SetShiftFraction, references r, size_t n, fmi3UInt64 const *counters, fmi3UInt64 const *resolutions)
REFUSED(fmi3GetOutputDerivatives, references r, size_t n, fmi3Int32 const *orders, fmi3Float64 *values, size_t m)
REFUSED(fmi3ActivateModelPartition, fmi3ValueReference clock, fmi3Float64 time)

EXPORTED fmi3Instance fmi3InstantiateScheduledExecution(
    fmi3String name, fmi3String token, fmi3String path, fmi3Boolean visible, fmi3Boolean logs,
    fmi3InstanceEnvironment environment, fmi3LogMessageCallback log, fmi3ClockUpdateCallback update,
    fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock) {
  struct unit said = {.environment = environment, .log = log};
  refused(&said, "fmi3InstantiateScheduledExecution");
  return NULL;
}
)";

} // namespace symreal::tool
