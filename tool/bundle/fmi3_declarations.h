// Beginning of a unit's C code: types of FMI 3.0, and the instance. A pattern (emit/language/pattern.h).
#pragma once

#include <string_view>

namespace symreal::tool {

inline constexpr std::string_view fmi3_declarations =
    R"(/* The functions of FMI 3.0 (fmi-standard.org) around the generated functions. */
#include "$base.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#if defined _WIN32
#define EXPORTED __declspec(dllexport)
#elif defined __GNUC__
#define EXPORTED __attribute__((visibility("default")))
#else
#define EXPORTED
#endif

typedef void *fmi3Instance;
typedef void *fmi3InstanceEnvironment;
typedef void *fmi3FMUState;
typedef uint32_t fmi3ValueReference;
typedef float fmi3Float32;
typedef double fmi3Float64;
typedef int8_t fmi3Int8;
typedef uint8_t fmi3UInt8;
typedef int16_t fmi3Int16;
typedef uint16_t fmi3UInt16;
typedef int32_t fmi3Int32;
typedef uint32_t fmi3UInt32;
typedef int64_t fmi3Int64;
typedef uint64_t fmi3UInt64;
typedef bool fmi3Boolean;
typedef char const *fmi3String;
typedef uint8_t fmi3Byte;
typedef fmi3Byte const *fmi3Binary;
typedef bool fmi3Clock;
typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;
typedef int fmi3DependencyKind, fmi3IntervalQualifier;
typedef void (*fmi3LogMessageCallback)(fmi3InstanceEnvironment, fmi3Status, fmi3String category, fmi3String message);
typedef void (*fmi3ClockUpdateCallback)(fmi3InstanceEnvironment);
typedef void (*fmi3IntermediateUpdateCallback)(fmi3InstanceEnvironment, fmi3Float64, fmi3Boolean, fmi3Boolean,
                                               fmi3Boolean, fmi3Boolean, fmi3Boolean *, fmi3Float64 *);
typedef void (*fmi3LockPreemptionCallback)(void);
typedef void (*fmi3UnlockPreemptionCallback)(void);

/* A value reference is an index of `value`: time, inputs, parameters, outputs. */
enum { at_input = 1, at_parameter = at_input + $inputs, at_output = at_parameter + $parameters,
       value_count = at_output + $outputs, state_count = $states };
static uint32_t const state[state_count] = {$state_places
};
static uint32_t const derivative[state_count] = {$derivative_places
};
static double const start[value_count] = {$start_values
};

/* The states of FMI's state machine that this unit has. */
enum { instantiated = 1, initialization_mode = 2, event_mode = 4, continuous_time_mode = 8, step_mode = 16,
       terminated = 32, any_state = 63 };

struct unit {
  double value[value_count], constants[$constants_or_one];
  bool has_constants, has_outputs; /* they are those of the parameters, of the inputs and parameters */
  bool takes_steps;                /* co-simulation */
  unsigned at;                     /* its state */
  double end;                      /* no step goes beyond this time */
  fmi3InstanceEnvironment environment;
  fmi3LogMessageCallback log;
};

/* An error ends the simulation: from then on values can be read, and the unit can be reset. */
static fmi3Status say(struct unit *unit, fmi3Status status, char const *message) {
  if (unit && unit->log)
    unit->log(unit->environment, status, status == fmi3Discard ? "logStatusDiscard" : "logStatusError", message);
  if (unit && status == fmi3Error) unit->at = terminated;
  return status;
}

static fmi3Status say_of(struct unit *unit, char const *function, char const *what) {
  char message[200] = "";
  strncat(message, function, sizeof message - 1);
  strncat(message, what, sizeof message - strlen(message) - 1);
  return say(unit, fmi3Error, message);
}

static fmi3Status refused(fmi3Instance instance, char const *function) {
  return say_of(instance, function, " is not supported by this unit");
}

/* Whether a function may be called now; else the message has been given. */
static bool is_allowed(struct unit *unit, unsigned states, char const *function) {
  if (!unit) return false;
  if ((unit->at & states) != 0) return true;
  say_of(unit, function,
         unit->at == instantiated           ? " is not allowed before fmi3EnterInitializationMode"
         : unit->at == initialization_mode  ? " is not allowed in Initialization Mode"
         : unit->at == event_mode           ? " is not allowed in Event Mode"
         : unit->at == continuous_time_mode ? " is not allowed in Continuous-Time Mode"
         : unit->at == step_mode            ? " is not allowed in Step Mode"
                                            : " is not allowed after fmi3Terminate or an error");
  return false;
}

static bool is_finite(double x) { return x - x == 0.0; }

/* Times that differ by rounding alone are the same. */
static double rounding(double time) { return 1e-9 * (1.0 + (time < 0.0 ? -time : time)); }

static void reset(struct unit *unit) {
  memcpy(unit->value, start, sizeof start);
  unit->has_constants = unit->has_outputs = false;
  unit->at = instantiated;
}

static struct unit *make(fmi3String token, bool takes_steps, fmi3InstanceEnvironment environment,
                         fmi3LogMessageCallback log) {
  struct unit made = {.takes_steps = takes_steps, .environment = environment, .log = log};
  if (!token || strcmp(token, "$token") != 0) {
    say(&made, fmi3Error, "the instantiation token is that of another unit");
    return NULL;
  }
  struct unit *const unit = malloc(sizeof *unit);
  if (!unit) return NULL;
  *unit = made;
  reset(unit);
  return unit;
}

/* A guard that does not hold is fmi3Discard, not an error: the function is not defined at these values, and an
   integrator may try others, with a smaller step. */
static fmi3Status evaluate(struct unit *unit) {
  if (unit->has_outputs) return fmi3OK;
  if (!unit->has_constants) $preprocess(unit->value + at_parameter, unit->constants);
  unit->has_constants = true;
  $call
  unit->has_outputs = true;
  return fmi3OK;
}
)";

inline constexpr std::string_view fmi3_call =
    "$compute(unit->value + at_input, unit->constants, unit->value + at_output);";
inline constexpr std::string_view fmi3_checked_call =
    R"(int const guard = $compute(unit->value + at_input, unit->constants, unit->value + at_output);
  if (guard != 0) return say(unit, fmi3Discard, $guard_text(guard));)";

} // namespace symreal::tool
