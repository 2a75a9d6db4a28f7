# Helpers of Maple, and the code around functions, for maple.toml. Marks: language_file.h.

# @helper in_reals
in_reals := proc(x)
  if type(x, numeric) then x else Float(undefined) end if
end proc:

# @helper hypot
hypot := proc(x, y) option hfloat;
  local a, b;
  a := max(abs(x), abs(y));
  b := min(abs(x), abs(y));
  if a = 0 then a else a*sqrt(1.0 + (b/a)^2) end if
end proc:

# @helper fdim
fdim := proc(x, y) option hfloat;
  if x <= y then 0.0 else x - y end if
end proc:

# @helper fmod
fmod := proc(x, y) option hfloat;
  local r;
  r := frem(abs(x), abs(y));
  if r < 0 then r := r + abs(y) end if;
  CopySign(r, x)
end proc:

# @helper rint
rint := proc(x) option hfloat;
  if abs(x - trunc(x)) = 0.5 then 2.0*round(x/2) else 1.0*round(x) end if
end proc:

# @helper expm1
expm1 := proc(x) option hfloat;
  if abs(x) < 1 then 2.0*exp(x/2)*sinh(x/2) else exp(x) - 1 end if
end proc:

# @helper log1p
log1p := proc(x) option hfloat;
  in_reals(`if`(abs(x) < 0.5, 2.0*arctanh(x/(2 + x)), ln(1 + x)))
end proc:

# @helper table_index
# An index outside of its table reads the nearest element.
table_index := proc(index, extent)
  if not evalb(index > 0) then 0 elif index < extent then trunc(index) else extent - 1 end if
end proc:

# @helper as_signed
as_signed := proc(x)
  if x >= 2^63 then x - 2^64 else x end if
end proc:

# @helper whole
whole := proc(x)
  if x >= -9223372036854775808 and x < 9223372036854775808 then trunc(x) else -9223372036854775808 end if
end proc:

# @helper to_int32
to_int32 := proc(x)
  if x > -2147483649 and x < 2147483648 then 1.0*trunc(x) else -2147483648.0 end if
end proc:

# @helper to_int64
to_int64 := proc(x)
  1.0*whole(x)
end proc:

# @helper low_bits
low_bits := proc(x, width)
  1.0*modp(whole(x), 2^width)
end proc:

# @helper wrapped
wrapped := proc(x, width)
  local low;
  low := modp(whole(x), 2^width);
  if low >= 2^(width - 1) then low := low - 2^width end if;
  1.0*low
end proc:

# @helper wide_int
wide_int := proc(x)
  modp(whole(x), 2^64)
end proc:

# @helper wide_uint
wide_uint := proc(x)
  if x >= 2^63 and x < 2^64 then trunc(x) else wide_int(x) end if
end proc:

# @helper wide
wide := proc(high, low)
  modp(whole(high)*2^32, 2^64) + modp(whole(low), 2^32)
end proc:

# @helper int_div
int_div := proc(x, y) option hfloat;
  1.0*trunc(x/y)
end proc:

# @helper int_neg
int_neg := proc(x) option hfloat;
  if x = 0 then 0.0 else -x end if
end proc:

# @helper mul_uint32
mul_uint32 := proc(x, y)
  1.0*modp(whole(x)*whole(y), 2^32)
end proc:

# @helper wide_div
wide_div := proc(x, y)
  if y = 0 then 0 else modp(iquo(as_signed(x), as_signed(y)), 2^64) end if
end proc:

# @helper wide_rem
wide_rem := proc(x, y)
  if y = 0 then 0 else modp(irem(as_signed(x), as_signed(y)), 2^64) end if
end proc:

# @helper wide_udiv
wide_udiv := proc(x, y)
  if y = 0 then 0 else iquo(x, y) end if
end proc:

# @helper wide_urem
wide_urem := proc(x, y)
  if y = 0 then 0 else irem(x, y) end if
end proc:

# @helper wide_and
wide_and := proc(x, y)
  Bits:-And(x, y)
end proc:

# @helper wide_or
wide_or := proc(x, y)
  Bits:-Or(x, y)
end proc:

# @helper wide_xor
wide_xor := proc(x, y)
  Bits:-Xor(x, y)
end proc:

# @helper wide_shl
wide_shl := proc(x, n)
  modp(x*2^modp(n, 64), 2^64)
end proc:

# @helper wide_shr
wide_shr := proc(x, n)
  modp(floor(as_signed(x)/2^modp(n, 64)), 2^64)
end proc:

# @helper wide_ushr
wide_ushr := proc(x, n)
  iquo(x, 2^modp(n, 64))
end proc:

# @helper wide_less
wide_less := proc(x, y)
  evalb(as_signed(x) < as_signed(y))
end proc:

# @text module.main

# Runs the kernel once and prints its outputs. A list `given` replaces the recorded inputs in order, then the parameters:
#   maple -q -c "given := [1.5, 2.5]:" ${base}_main.mpl
read "$base.mpl":
recorded := [$all_values]:
names := [$labels]:
if not type(given, list) then given := [] end if:
numbers := [op(given), op(recorded[nops(given) + 1 .. $inputs + $parameters])]:
$call
for i to nops(names) do
  printf("%s = %.17g\n", names[i], output[i]);
end do:
