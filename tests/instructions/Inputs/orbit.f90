subroutine orbit(x, a) bind(c)
  use iso_c_binding
  implicit none
  real(c_double), intent(in) :: x(3)
  real(c_double), intent(out) :: a(3)
  real(c_double) :: r2
  integer :: i
  r2 = dot_product(x, x)
  do i = 1, 3
    a(i) = -x(i) / (r2 * sqrt(r2))
  end do
end subroutine
