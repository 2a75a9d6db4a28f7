/* What a generated S-function uses of Simulink's header, for a test without Simulink. Written from the reference of the
   S-function interface; nothing of Simulink's own text. */
#ifndef SIMSTRUC_H
#define SIMSTRUC_H

#include <stddef.h>
#include <stdlib.h>

typedef int int_T;
typedef struct {
  double numbers[64];
  size_t count;
} mxArray;

typedef struct {
  int parameters, given, inputs, outputs, times, tunable;
  mxArray parameter[8];
  int input_width[8], output_width[8], contiguous[8], through[8];
  double input[8][64], output[8][64], *work, period, offset;
  char const *status;
} SimStruct;

static int mxIsDouble(mxArray const *array) { return array != NULL; }
static int mxIsComplex(mxArray const *array) { return array == NULL; }
static size_t mxGetNumberOfElements(mxArray const *array) { return array->count; }
static double *mxGetPr(mxArray const *array) { return (double *)array->numbers; }

#define INHERITED_SAMPLE_TIME -1.0
#define ssSetNumSFcnParams(S, n) ((S)->parameters = (n))
#define ssGetNumSFcnParams(S) ((S)->parameters)
#define ssGetSFcnParamsCount(S) ((S)->given)
#define ssGetSFcnParam(S, k) ((mxArray const *)&(S)->parameter[k])
#define ssSetSFcnParamTunable(S, k, yes) ((S)->tunable += (yes) + 0 * (k))
#define ssSetErrorStatus(S, text) ((S)->status = (text))
#define ssGetErrorStatus(S) ((S)->status)
#define ssSetNumInputPorts(S, n) ((S)->inputs = (n), 1)
#define ssSetNumOutputPorts(S, n) ((S)->outputs = (n), 1)
#define ssSetInputPortWidth(S, k, n) ((S)->input_width[k] = (n))
#define ssSetOutputPortWidth(S, k, n) ((S)->output_width[k] = (n))
#define ssSetInputPortRequiredContiguous(S, k, yes) ((S)->contiguous[k] = (yes))
#define ssSetInputPortDirectFeedThrough(S, k, yes) ((S)->through[k] = (yes))
#define ssSetNumRWork(S, n) ((S)->work = calloc((size_t)(n) + 1, sizeof(double)))
#define ssGetRWork(S) ((S)->work)
#define ssSetNumSampleTimes(S, n) ((S)->times = (n))
#define ssSetSampleTime(S, k, value) ((S)->period = (value) + 0 * (k))
#define ssSetOffsetTime(S, k, value) ((S)->offset = (value) + 0 * (k))
#define ssGetInputPortRealSignal(S, k) ((double const *)(S)->input[k])
#define ssGetOutputPortRealSignal(S, k) ((S)->output[k])

#endif
