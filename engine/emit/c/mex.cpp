// MEX gateway to generated C for MATLAB and Octave, in their common interface (mxGetPr, real doubles).
#include "engine/emit/c/parts.h"
#include "engine/emit/print/banner.h"
#include "engine/emit/print/module.h"

namespace symreal {

static constexpr std::string_view gateway =
    R"c(/* Built by: mex ${base}_mex.c $base.c    or: mkoctfile --mex ${base}_mex.c $base.c

   constants = ${base}_mex('preprocess', parameters)
   output = ${base}_mex('compute', input, constants)

   Each column of input is a sample, and gives a column of output; without constants parameters are as well left out.
   A guard that does not hold is an error; [output, guard] = ... gives the number of the first such guard of each sample
   instead, 0 where all hold, and leaves that column of output at NaN. */
#include "$base.h"

#include <mex.h>
#include <string.h>

static double const *numbers(mxArray const *array, size_t count, char const *name) {
  if (!mxIsDouble(array) || mxIsComplex(array) || mxIsSparse(array))
    mexErrMsgIdAndTxt("$module:type", "%s is no full array of real doubles", name);
  if (mxGetNumberOfElements(array) != count)
    mexErrMsgIdAndTxt("$module:size", "%s has %d numbers, not %d", name, (int)mxGetNumberOfElements(array), (int)count);
  return mxGetPr(array);
}

/* The given parameters; none may be left out where there are none. */
static void prepare(int count, mxArray const *given[], double *constants) {
  double const *parameters = NULL;
  if (count > 0) parameters = numbers(given[0], $parameter_count, "parameters");
  else if ($parameter_count > 0) mexErrMsgIdAndTxt("$module:size", "parameters has 0 numbers, not %d", $parameter_count);
  $preprocess(parameters, constants);
}

static size_t sample_count(mxArray const *input) {
  if ($input_count == 0 || mxGetNumberOfElements(input) == $input_count) return 1;
  if (mxGetM(input) != $input_count)
    mexErrMsgIdAndTxt("$module:size", "input has %d rows, not %d", (int)mxGetM(input), $input_count);
  return mxGetNumberOfElements(input) / $input_count;
}

static void run(int result_count, mxArray *result[], mxArray const *given_input, double const *constants) {
  size_t const samples = sample_count(given_input);
  double const *input = numbers(given_input, samples * $input_count, "input");
  double *output, *guard = NULL;
  result[0] = mxCreateDoubleMatrix($output_count, samples, mxREAL);
  output = mxGetPr(result[0]);
  if (result_count > 1) {
    result[1] = mxCreateDoubleMatrix(1, samples, mxREAL);
    guard = mxGetPr(result[1]);
  }
  for (size_t k = 0; k < samples; ++k, input += $input_count, output += $output_count) {
$call
  }
}

void mexFunction(int result_count, mxArray *result[], int given_count, mxArray const *given[]) {
  char task[16] = "";
  if (given_count < 1 || mxGetString(given[0], task, sizeof task) != 0) task[0] = 0;
  if (strcmp(task, "preprocess") == 0 && given_count <= 2) {
    result[0] = mxCreateDoubleMatrix($constant_count, 1, mxREAL);
    prepare(given_count - 1, given + 1, mxGetPr(result[0]));
  } else if (strcmp(task, "compute") == 0 && given_count == 2) {
    mxArray *constants = mxCreateDoubleMatrix($constant_count, 1, mxREAL);
    prepare(0, NULL, mxGetPr(constants));
    run(result_count, result, given[1], mxGetPr(constants));
  } else if (strcmp(task, "compute") == 0 && given_count == 3) {
    run(result_count, result, given[1], numbers(given[2], $constant_count, "constants"));
  } else {
    mexErrMsgIdAndTxt("$module:use", "use ${base}_mex('preprocess', parameters) or ${base}_mex('compute', input, constants)");
}
}
)c";

static constexpr std::string_view call = R"c(    $compute(input, constants, output);
    if (guard != NULL) guard[k] = 0.0;)c";

static constexpr std::string_view checked_call = R"c(    int const failed = $compute(input, constants, output);
    if (guard != NULL) guard[k] = failed;
    if (failed == 0) continue;
    if (guard == NULL)
      mexErrMsgIdAndTxt("$module:guard", "guard %d of sample %d does not hold: %s", failed, (int)k + 1, $guard_text(failed));
    for (int i = 0; i < $output_count; ++i) output[i] = mxGetNaN();)c";

std::string c_mex(Emission const &emission) {
  Filling fill = interface_names(emission);
  fill.set("call", fill(emission.graph().guards.empty() ? call : checked_call));
  return banner(emission) + fill(gateway);
}

} // namespace symreal
