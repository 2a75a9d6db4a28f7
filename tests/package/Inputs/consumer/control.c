#include "track.h"

double control(double position, double rate) {
  double input[track_input_count] = {position, rate}, constants[1], output[track_output_count];
  track_compute(input, constants, output);
  return output[0];
}
