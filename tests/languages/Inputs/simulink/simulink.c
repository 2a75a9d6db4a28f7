/* In place of Simulink's end of an S-function: a program that does what Simulink does in one step, with the numbers that
   are its arguments, inputs before parameters, and prints what stands at the outputs. */
#include <stdio.h>

int main(int argc, char **argv) {
  static SimStruct block;
  int at = 1, k, i;
  block.given = block_parameters;
  for (k = 0; k < block_parameters; ++k) block.parameter[k].count = (size_t)parameter_size[k];
  mdlInitializeSizes(&block);
  mdlInitializeSampleTimes(&block);
  for (k = 0; k < block.inputs; ++k)
    for (i = 0; i < block.input_width[k]; ++i) block.input[k][i] = at < argc ? strtod(argv[at++], NULL) : 0.0;
  for (k = 0; k < block.parameters; ++k)
    for (i = 0; i < parameter_size[k]; ++i) block.parameter[k].numbers[i] = at < argc ? strtod(argv[at++], NULL) : 0.0;
  mdlStart(&block);
  mdlOutputs(&block, 0);
  mdlTerminate(&block);
  if (ssGetErrorStatus(&block) != NULL) {
    printf("error: %s\n", ssGetErrorStatus(&block));
    return 1;
  }
  printf("%d inputs, %d parameters\n", block.inputs, block.tunable);
  for (k = 0; k < block.outputs; ++k)
    for (i = 0; i < block.output_width[k]; ++i) printf("output %d, %d = %.17g\n", k + 1, i + 1, block.output[k][i]);
  free(block.work);
  return 0;
}
