program driver
  use, intrinsic :: iso_c_binding, only: c_double, c_int64_t
  use @NAMESPACE@_kernel, only: preprocess, compute
  implicit none
  real(c_double) :: values(@INPUTS@ + @PARAMETERS@ + 1), constants(@CONSTANTS@ + 1), output(@OUTPUTS@ + 1), first, total
  integer(c_int64_t) :: calls, i, begin, finish, rate
  integer :: unit, status
  open (newunit=unit, file='values')
  do i = 1, @INPUTS@ + @PARAMETERS@
    read (unit, *) values(i)
  end do
  first = values(1)
  call preprocess(values(@INPUTS@ + 1:), constants)
  do
    read (*, *, iostat=status) calls
    if (status /= 0) exit
    total = 0
    call system_clock(begin, rate)
    do i = 0, calls - 1
      values(1) = first + 1d-7*real(iand(i, 15_c_int64_t), c_double)
      call compute(values, constants, output)
      total = total + output(1)
    end do
    call system_clock(finish)
    write (*, '(es25.16e3, 1x, es25.16e3)') real(finish - begin, c_double)*1d9/real(rate, c_double)/real(calls, c_double), total
    flush (6)
  end do
end program
