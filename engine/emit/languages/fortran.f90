! Helpers of Fortran, and the code around functions, for fortran.toml. Marks: language_file.h.

! @declaration c_cbrt
interface
  pure function c_cbrt(x) bind(c, name='cbrt$f') result(y)
    import :: $kind
    $real, value :: x
    $real :: y
  end function
end interface

! @declaration c_hypot
interface
  pure function c_hypot(x, y) bind(c, name='hypot$f') result(z)
    import :: $kind
    $real, value :: x, y
    $real :: z
  end function
end interface

! @declaration c_fma
interface
  pure function c_fma(x, y, z) bind(c, name='fma$f') result(r)
    import :: $kind
    $real, value :: x, y, z
    $real :: r
  end function
end interface

! @like c_hypot c_fmin c_fmax c_fdim c_fmod c_remainder
! @like c_cbrt c_floor c_ceil c_round c_rint
! @like c_hypot c_nextafter
! @like c_cbrt c_logb c_sin c_cos c_tan c_asin c_acos c_atan
! @like c_hypot c_atan2
! @like c_cbrt c_sinh c_cosh c_tanh c_asinh c_acosh c_atanh c_exp c_exp2 c_expm1 c_log c_log2 c_log10 c_log1p
! @like c_hypot c_pow
! @like c_cbrt c_erf c_erfc c_tgamma c_lgamma

! @declaration infinity
$real, parameter :: infinity = $infinity

! @declaration not_a_number
$real, parameter :: not_a_number = $nan

! @helper table_index
! An index outside of its table reads the nearest element.
pure function table_index(index, extent) result(at)
  $real, intent(in) :: index
  integer, intent(in) :: extent
  integer :: at
  at = 0
  if (index > 0) at = extent - 1
  if (index > 0 .and. index < extent) at = int(index)
end function

! @helper wide_int
pure function wide_int(x) result(y)
  $real, intent(in) :: x
  integer(c_int64_t) :: y
  y = ibset(0_c_int64_t, 63)
  if (x >= -9223372036854775808.0$suffix .and. x < 9223372036854775808.0$suffix) y = int(x, c_int64_t)
end function

! @helper wide_uint
pure function wide_uint(x) result(y)
  $real, intent(in) :: x
  integer(c_int64_t) :: y
  if (x >= 9223372036854775808.0$suffix) then
    y = ieor(wide_int(x - 9223372036854775808.0$suffix), ibset(0_c_int64_t, 63))
  else
    y = wide_int(x)
  end if
end function

! @helper wide
pure function wide(high, low) result(y)
  $real, intent(in) :: high, low
  integer(c_int64_t) :: y
  y = ior(ishft(wide_int(high), 32), ibits(wide_int(low), 0, 32))
end function

! @helper low_bits
pure function low_bits(x, width) result(y)
  $real, intent(in) :: x
  integer, intent(in) :: width
  $real :: y
  y = real(ibits(wide_int(x), 0, width), $kind)
end function

! @helper wrapped
pure function wrapped(x, width) result(y)
  $real, intent(in) :: x
  integer, intent(in) :: width
  $real :: y
  y = low_bits(x, width)
  if (y >= 2.0$suffix**(width - 1)) y = y - 2.0$suffix**width
end function

! @helper to_int32
pure function to_int32(x) result(y)
  $real, intent(in) :: x
  $real :: y
  y = -2147483648.0$suffix
  if (x > -2147483649.0$suffix .and. x < 2147483648.0$suffix) y = aint(x) + 0.0$suffix
end function

! @helper to_int64
pure function to_int64(x) result(y)
  $real, intent(in) :: x
  $real :: y
  y = real(wide_int(x), $kind)
end function

! @helper int_div
pure function int_div(x, y) result(z)
  $real, intent(in) :: x, y
  $real :: z
  z = aint(x/y) + 0.0$suffix
end function

! @helper int_neg
pure function int_neg(x) result(y)
  $real, intent(in) :: x
  $real :: y
  y = -x
  if (x == 0) y = 0
end function

! @helper mul_uint32
pure function mul_uint32(x, y) result(z)
  $real, intent(in) :: x, y
  $real :: z
  z = real(ibits(wide_mul(wide_int(x), wide_int(y)), 0, 32), $kind)
end function

! @helper wide_add
! Integers wrap: Fortran leaves overflow undefined, so sums are made of halves.
pure function wide_add(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z, low, high
  low = ibits(x, 0, 32) + ibits(y, 0, 32)
  high = ishft(x, -32) + ishft(y, -32) + ishft(low, -32)
  z = ior(ishft(high, 32), ibits(low, 0, 32))
end function

! @helper wide_mul
pure function wide_mul(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z, part
  integer :: k
  z = 0
  do k = 0, 48, 16
    part = ibits(y, k, 16)
    z = wide_add(z, ishft(ibits(x, 0, 32)*part, k))
    z = wide_add(z, ishft(ishft(x, -32)*part, k + 32))
  end do
end function

! @helper wide_uless
pure function wide_uless(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  logical :: z
  z = ieor(x, ibset(0_c_int64_t, 63)) < ieor(y, ibset(0_c_int64_t, 63))
end function

! @helper wide_less
pure function wide_less(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  logical :: z
  z = x < y
end function

! @helper wide_uvalue
pure function wide_uvalue(x) result(y)
  integer(c_int64_t), intent(in) :: x
  $real :: y
  if (x >= 0) then
    y = real(x, $kind)
  else
    y = real(ior(ishft(x, -1), iand(x, 1_c_int64_t)), $kind)*2
  end if
end function

! @helper wide_udiv
pure function wide_udiv(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z, rest
  integer :: k
  z = 0
  rest = 0
  if (y == 0) return
  do k = 63, 0, -1
    if (rest < 0 .or. wide_uless(ior(ishft(rest, 1), ibits(x, k, 1)), y) .eqv. .false.) then
      rest = wide_add(wide_add(ior(ishft(rest, 1), ibits(x, k, 1)), not(y)), 1_c_int64_t)
      z = ibset(z, k)
    else
      rest = ior(ishft(rest, 1), ibits(x, k, 1))
    end if
  end do
end function

! @helper wide_urem
pure function wide_urem(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z
  z = 0
  if (y /= 0) z = wide_add(wide_add(x, not(wide_mul(wide_udiv(x, y), y))), 1_c_int64_t)
end function

! @helper wide_div
pure function wide_div(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z
  z = 0
  if (y == -1) then
    z = wide_add(not(x), 1_c_int64_t)
  else if (y /= 0) then
    z = x/y
  end if
end function

! @helper wide_rem
pure function wide_rem(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z
  z = 0
  if (y /= 0 .and. y /= -1) z = mod(x, y)
end function

! @helper wide_and
pure function wide_and(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z
  z = iand(x, y)
end function

! @helper wide_or
pure function wide_or(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z
  z = ior(x, y)
end function

! @helper wide_xor
pure function wide_xor(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z
  z = ieor(x, y)
end function

! @helper wide_shl
pure function wide_shl(x, n) result(z)
  integer(c_int64_t), intent(in) :: x, n
  integer(c_int64_t) :: z
  z = ishft(x, int(ibits(n, 0, 6)))
end function

! @helper wide_shr
pure function wide_shr(x, n) result(z)
  integer(c_int64_t), intent(in) :: x, n
  integer(c_int64_t) :: z
  z = shifta(x, int(ibits(n, 0, 6)))
end function

! @helper wide_ushr
pure function wide_ushr(x, n) result(z)
  integer(c_int64_t), intent(in) :: x, n
  integer(c_int64_t) :: z
  z = ishft(x, -int(ibits(n, 0, 6)))
end function

! @text externals.bridge.declaration
interface
  function c_$name($names) bind(c, name='$c_name') result(y)
    use, intrinsic :: iso_c_binding
$structures$declared    $result :: y
  end function
end interface

! @text externals.bridge.declaration_without_result
interface
  subroutine c_$name($names) bind(c, name='$c_name')
    use, intrinsic :: iso_c_binding
$structures$declared  end subroutine
end interface

! @text externals.bridge.bridge
subroutine $name(a, r)
  use, intrinsic :: iso_c_binding
  real(c_double), intent(in) :: a(*)
  real(c_double), intent(inout) :: r(*)
$locals$copies${stored}end subroutine

! @text module.begin
module ${module}_kernel
  use, intrinsic :: iso_c_binding, only: c_double, c_float, c_int64_t
  implicit none
  private :: c_double, c_float, c_int64_t


! @text module.guards_begin

  ! The condition of a guard and its places in the source.
  function $guard_text(guard) result(text)
    integer, intent(in) :: guard
    character(len=:), allocatable :: text
    select case (guard)

! @text module.guards_end
    case default
      text = ''
    end select
  end function $guard_text

! @text module.main
! Runs the kernel once and prints its outputs. Arguments replace the recorded inputs in order, then the parameters.
program ${unit}_main
  use, intrinsic :: iso_c_binding, only: $kind, c_int64_t
  use, intrinsic :: iso_fortran_env, only: error_unit
  use ${module}_kernel, only: $preprocess, $compute$guard_text_import
  implicit none
  $real, parameter :: infinity = $infinity
  $real, parameter :: not_a_number = $nan
  $real :: given($inputs + $parameters) = [$real :: $all_values]
  character(len=$longest), parameter :: names($outputs) = [character(len=$longest) :: $labels]
  $real :: constants($constants), output($outputs), number
  character(len=64) :: argument
  integer :: i, guard
  do i = 1, command_argument_count()
    call get_command_argument(i, argument)
    read (argument, *) number
    if (i <= size(given)) given(i) = number
  end do
  guard = 0
  call $preprocess(given($inputs + 1:), constants)
  $call
  do i = 1, size(output)
    write (*, '(a, " = ", es25.16e3)') trim(names(i)), output(i)
  end do
  if (.false.) write (error_unit, *) infinity, not_a_number, guard
end program
