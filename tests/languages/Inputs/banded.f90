program main
  use banded_kernel
  implicit none
  integer, parameter :: n = jacobian_y_x_rows
  integer :: i, k
  if (n /= 2100 .or. jacobian_y_x_nonzeros /= 2*n .or. jacobian_y_x_columns /= n + 1) stop 1
  if (any(jacobian_y_x_row /= [((i, k = 1, 2), i = 1, n)])) stop 2
  if (any(jacobian_y_x_column /= [((i + k, k = 0, 1), i = 1, n)])) stop 3
  if (any(jacobian_y_x_row_start /= [(2*i - 1, i = 1, n + 1)])) stop 4
  if (any(jacobian_y_x_column_start /= [1, (2*i, i = 1, n + 1)] - [(0, i = 0, n), 1])) stop 5
  if (any(jacobian_y_x_row_by_column /= [((i, k = 1, 2), i = 1, n)])) stop 6
  if (any(jacobian_y_x_column(jacobian_y_x_by_column) /= [1, ((i, k = 1, 2), i = 2, n), n + 1])) stop 7
end program
