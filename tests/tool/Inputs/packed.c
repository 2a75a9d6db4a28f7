// The packed Jacobian and its lists, against the dense one.
#include "k.h"
#include "packed.h"

int main(void) {
  double input[input_count] = {0.5, 1.25, -0.75, 2, 1, 1, 1, 1}, output[output_count], packed[packed_output_count];
  compute(input, input, output);
  packed_compute(input, input, packed);
  double const *const dense = output + output_jacobian_y_x, *const stored = packed + packed_output_jacobian_y_x;
  int found = 0;
  for (int k = 0; k < packed_jacobian_y_x_nonzeros; k++) {
    int const row = packed_jacobian_y_x_row[k], column = packed_jacobian_y_x_column[k];
    if (dense[4 * row + column] != stored[k]) return 1;
    if (k < packed_jacobian_y_x_row_start[row] || k >= packed_jacobian_y_x_row_start[row + 1]) return 2;
  }
  for (int j = 0; j < packed_jacobian_y_x_columns; j++)
    for (int at = packed_jacobian_y_x_column_start[j]; at < packed_jacobian_y_x_column_start[j + 1]; at++, found++)
      if (dense[4 * packed_jacobian_y_x_row_by_column[at] + j] != stored[packed_jacobian_y_x_by_column[at]]) return 3;
  return found == packed_jacobian_y_x_nonzeros ? 0 : 4;
}
