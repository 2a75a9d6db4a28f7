// Simulink block for generated C: a level-2 S-function.
#include "engine/emit/c/parts.h"
#include "engine/emit/print/banner.h"
#include "engine/emit/print/module.h"
#include "engine/graph/names.h"

#include <fmt/format.h>

namespace symreal {

static constexpr std::string_view block = R"(/* Built by: mex ${base}_sfun.c $base.c

   Each input and output object is a port, each parameter object a parameter of the block, which may be changed while the
   model runs. Their numbers are in the order of C: the last index is the fastest.
$ports
   A guard that does not hold stops the simulation with its text. */
#define S_FUNCTION_NAME ${base}_sfun
#define S_FUNCTION_LEVEL 2

#include "$base.h"

#include <simstruc.h>
#include <stddef.h>

/* Sizes of the objects; the 0 behind them is none. */
static int const input_size[] = {${input_sizes}0};
static int const parameter_size[] = {${parameter_sizes}0};
static int const output_size[] = {${output_sizes}0};
enum { input_ports = $input_ports, output_ports = $output_ports, block_parameters = $block_parameters };

#define MDL_CHECK_PARAMETERS
static void mdlCheckParameters(SimStruct *S) {
  int k;
  for (k = 0; k < block_parameters; ++k) {
    mxArray const *value = ssGetSFcnParam(S, k);
    if (mxIsDouble(value) && !mxIsComplex(value) && (int)mxGetNumberOfElements(value) == parameter_size[k]) continue;
    ssSetErrorStatus(S, "a parameter of $base is no array of real doubles of its size");
    return;
  }
}

static void mdlInitializeSizes(SimStruct *S) {
  int k;
  ssSetNumSFcnParams(S, block_parameters);
  if (ssGetNumSFcnParams(S) != ssGetSFcnParamsCount(S)) return; /* Simulink reports it */
  mdlCheckParameters(S);
  if (ssGetErrorStatus(S) != NULL) return;
  for (k = 0; k < block_parameters; ++k) ssSetSFcnParamTunable(S, k, 1);
  if (!ssSetNumInputPorts(S, input_ports)) return;
  for (k = 0; k < input_ports; ++k) {
    ssSetInputPortWidth(S, k, input_size[k]);
    ssSetInputPortRequiredContiguous(S, k, 1);
    ssSetInputPortDirectFeedThrough(S, k, 1);
  }
  if (!ssSetNumOutputPorts(S, output_ports)) return;
  for (k = 0; k < output_ports; ++k) ssSetOutputPortWidth(S, k, output_size[k]);
  ssSetNumRWork(S, $constant_count + $input_count + $output_count);
  ssSetNumSampleTimes(S, 1);
}

static void mdlInitializeSampleTimes(SimStruct *S) {
  ssSetSampleTime(S, 0, INHERITED_SAMPLE_TIME);
  ssSetOffsetTime(S, 0, 0.0);
}

#define MDL_PROCESS_PARAMETERS
static void mdlProcessParameters(SimStruct *S) {
  double parameters[$parameter_count + 1];
  int k, i, at = 0;
  for (k = 0; k < block_parameters; ++k)
    for (i = 0; i < parameter_size[k]; ++i) parameters[at++] = mxGetPr(ssGetSFcnParam(S, k))[i];
  $preprocess(parameters, ssGetRWork(S));
}

#define MDL_START
static void mdlStart(SimStruct *S) { mdlProcessParameters(S); }

static void mdlOutputs(SimStruct *S, int_T task) {
  double *constants = ssGetRWork(S);
  double *input = constants + $constant_count, *output = input + $input_count;
  int k, i;
  (void)task;
  for (k = 0; k < input_ports; ++k) {
    double const *signal = ssGetInputPortRealSignal(S, k);
    for (i = 0; i < input_size[k]; ++i) *input++ = signal[i];
  }
  input -= $input_count;
$call
  for (k = 0; k < output_ports; ++k) {
    double *signal = ssGetOutputPortRealSignal(S, k);
    for (i = 0; i < output_size[k]; ++i) signal[i] = *output++;
  }
}

static void mdlTerminate(SimStruct *S) { (void)S; }

#ifdef MATLAB_MEX_FILE
#include "simulink.c"
#else
#include "cg_sfun.h"
#endif
)";

static constexpr std::string_view checked_call = R"(  i = $compute(input, constants, output);
  if (i != 0) {
    ssSetErrorStatus(S, $guard_text(i));
    return;
  })";

namespace {

struct Ports {
  std::size_t count = 0;
  std::string sizes, lines;
};

Ports ports(Emission const &emission, std::string const &role, std::vector<Object> const &objects) {
  std::vector<std::string> const names = identifiers(objects, emission.language.names);
  Ports ports;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].count == 0) continue;
    ports.sizes += fmt::format("{}, ", objects[i].count);
    ports.lines += fmt::format("     {} {}: {}, {} wide\n", role, ++ports.count, names[i], objects[i].count);
  }
  return ports;
}

} // namespace

std::string c_simulink(Emission const &emission) {
  Graph const &graph = emission.graph();
  Ports const inputs = ports(emission, "input", graph.inputs),
              parameters = ports(emission, "parameter", graph.parameters),
              outputs = ports(emission, "output", graph.outputs);
  Filling fill = interface_names(emission);
  fill.set("ports", inputs.lines + parameters.lines + outputs.lines);
  fill.set("input_sizes", inputs.sizes).set("parameter_sizes", parameters.sizes).set("output_sizes", outputs.sizes);
  fill.set("input_ports", inputs.count)
      .set("block_parameters", parameters.count)
      .set("output_ports", outputs.count)
      .set("call", graph.guards.empty() ? fill("  $compute(input, constants, output);") : fill(checked_call));
  return banner(emission) + fill(block);
}

} // namespace symreal
