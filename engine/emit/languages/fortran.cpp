#include "engine/emit/languages/languages.h"
#include "engine/emit/print/module.h"

#include <algorithm>
#include <array>

namespace symreal {

static constexpr auto keywords = std::to_array<std::string_view>(
    {"call",   "case", "contains",   "do",      "double", "else",      "end",     "function",
     "guard",  "if",   "implicit",   "integer", "intent", "interface", "logical", "module",
     "none",   "only", "parameter",  "program", "pure",   "real",      "result",  "return",
     "select", "stop", "subroutine", "then",    "type",   "use",       "while"});
static_assert(std::ranges::is_sorted(keywords));

// Functions of C's library are called by name; these operations are Fortran's own.
static constexpr OperationSpelling spellings[] = {
    {Op::neg, "-$x:14", 11},
    {Op::abs, "abs($x)"},
    {Op::sqrt, "sqrt($x)"},
    {Op::trunc, "aint($x)"},
    {Op::copysign, "sign($x, $y)"},
    {Op::f32, "real(real($x, c_float), $kind)"},
    {Op::wrap_int8, "wrapped($x, 8)"},
    {Op::wrap_int16, "wrapped($x, 16)"},
    {Op::wrap_int32, "wrapped($x, 32)"},
    {Op::wrap_uint8, "low_bits($x, 8)"},
    {Op::wrap_uint16, "low_bits($x, 16)"},
    {Op::wrap_uint32, "low_bits($x, 32)"},
    {Op::wide_add, "wide_add($x, $y)"},
    {Op::wide_sub, "wide_add(wide_add($x, not($y)), 1_c_int64_t)"},
    {Op::wide_mul, "wide_mul($x, $y)"},
    {Op::wide_select, "merge($y, $z, $x)"},
    {Op::wide_uless, "wide_uless($x, $y)"},
    {Op::wide_value, "real($x, $kind)"},
    {Op::wide_uvalue, "wide_uvalue($x)"},
    {Op::wide_low, "real(ibits($x, 0, 32), $kind)"},
    {Op::logical_and, "$x:12 .and. $y:12", 5},
    {Op::logical_or, "$x:12 .or. $y:12", 4},
    {Op::logical_not, ".not. $x:14", 6},
    {Op::ne, "$x:12 /= $y:12", 9},
    {Op::select, "merge($y, $z, $x)"},
};

#define OF_ONE(name)                                                                                                   \
  {"c_" #name,                                                                                                         \
   "interface\n  pure function c_" #name "(x) bind(c, name='" #name                                                    \
   "$f') result(y)\n    import :: $kind\n    $real, value :: x\n    $real :: y\n  end function\n"                      \
   "end interface\n",                                                                                                  \
   true}
#define OF_TWO(name)                                                                                                   \
  {"c_" #name,                                                                                                         \
   "interface\n  pure function c_" #name "(x, y) bind(c, name='" #name                                                 \
   "$f') result(z)\n    import :: $kind\n    $real, value :: x, y\n    $real :: z\n"                                   \
   "  end function\nend interface\n",                                                                                  \
   true}

static constexpr Helper helpers[] = {
    OF_ONE(cbrt),
    OF_TWO(hypot),
    {"c_fma", R"(interface
  pure function c_fma(x, y, z) bind(c, name='fma$f') result(r)
    import :: $kind
    $real, value :: x, y, z
    $real :: r
  end function
end interface
)",
     true},
    OF_TWO(fmin),
    OF_TWO(fmax),
    OF_TWO(fdim),
    OF_TWO(fmod),
    OF_TWO(remainder),
    OF_ONE(floor),
    OF_ONE(ceil),
    OF_ONE(round),
    OF_ONE(rint),
    OF_TWO(nextafter),
    OF_ONE(logb),
    OF_ONE(sin),
    OF_ONE(cos),
    OF_ONE(tan),
    OF_ONE(asin),
    OF_ONE(acos),
    OF_ONE(atan),
    OF_TWO(atan2),
    OF_ONE(sinh),
    OF_ONE(cosh),
    OF_ONE(tanh),
    OF_ONE(asinh),
    OF_ONE(acosh),
    OF_ONE(atanh),
    OF_ONE(exp),
    OF_ONE(exp2),
    OF_ONE(expm1),
    OF_ONE(log),
    OF_ONE(log2),
    OF_ONE(log10),
    OF_ONE(log1p),
    OF_TWO(pow),
    OF_ONE(erf),
    OF_ONE(erfc),
    OF_ONE(tgamma),
    OF_ONE(lgamma),
    {"infinity", "$real, parameter :: infinity = $infinity\n", true},
    {"not_a_number", "$real, parameter :: not_a_number = $nan\n", true},
    {"table_index", R"(! An index outside of its table reads the nearest element.
pure function table_index(index, extent) result(at)
  $real, intent(in) :: index
  integer, intent(in) :: extent
  integer :: at
  at = 0
  if (index > 0) at = extent - 1
  if (index > 0 .and. index < extent) at = int(index)
end function
)"},
    {"wide_int", R"(pure function wide_int(x) result(y)
  $real, intent(in) :: x
  integer(c_int64_t) :: y
  y = ibset(0_c_int64_t, 63)
  if (x >= -9223372036854775808.0$suffix .and. x < 9223372036854775808.0$suffix) y = int(x, c_int64_t)
end function
)"},
    {"wide_uint", R"(pure function wide_uint(x) result(y)
  $real, intent(in) :: x
  integer(c_int64_t) :: y
  if (x >= 9223372036854775808.0$suffix) then
    y = ieor(wide_int(x - 9223372036854775808.0$suffix), ibset(0_c_int64_t, 63))
  else
    y = wide_int(x)
  end if
end function
)"},
    {"wide", R"(pure function wide(high, low) result(y)
  $real, intent(in) :: high, low
  integer(c_int64_t) :: y
  y = ior(ishft(wide_int(high), 32), ibits(wide_int(low), 0, 32))
end function
)"},
    {"low_bits", R"(pure function low_bits(x, width) result(y)
  $real, intent(in) :: x
  integer, intent(in) :: width
  $real :: y
  y = real(ibits(wide_int(x), 0, width), $kind)
end function
)"},
    {"wrapped", R"(pure function wrapped(x, width) result(y)
  $real, intent(in) :: x
  integer, intent(in) :: width
  $real :: y
  y = low_bits(x, width)
  if (y >= 2.0$suffix**(width - 1)) y = y - 2.0$suffix**width
end function
)"},
    {"to_int32", R"(pure function to_int32(x) result(y)
  $real, intent(in) :: x
  $real :: y
  y = -2147483648.0$suffix
  if (x > -2147483649.0$suffix .and. x < 2147483648.0$suffix) y = aint(x) + 0.0$suffix
end function
)"},
    {"to_int64", R"(pure function to_int64(x) result(y)
  $real, intent(in) :: x
  $real :: y
  y = real(wide_int(x), $kind)
end function
)"},
    {"int_div", R"(pure function int_div(x, y) result(z)
  $real, intent(in) :: x, y
  $real :: z
  z = aint(x/y) + 0.0$suffix
end function
)"},
    {"int_neg", R"(pure function int_neg(x) result(y)
  $real, intent(in) :: x
  $real :: y
  y = -x
  if (x == 0) y = 0
end function
)"},
    {"mul_uint32", R"(pure function mul_uint32(x, y) result(z)
  $real, intent(in) :: x, y
  $real :: z
  z = real(ibits(wide_mul(wide_int(x), wide_int(y)), 0, 32), $kind)
end function
)"},
    {"wide_add", R"(! Integers wrap: Fortran leaves overflow undefined, so sums are made of halves.
pure function wide_add(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z, low, high
  low = ibits(x, 0, 32) + ibits(y, 0, 32)
  high = ishft(x, -32) + ishft(y, -32) + ishft(low, -32)
  z = ior(ishft(high, 32), ibits(low, 0, 32))
end function
)"},
    {"wide_mul", R"(pure function wide_mul(x, y) result(z)
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
)"},
    {"wide_uless", R"(pure function wide_uless(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  logical :: z
  z = ieor(x, ibset(0_c_int64_t, 63)) < ieor(y, ibset(0_c_int64_t, 63))
end function
)"},
    {"wide_less", R"(pure function wide_less(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  logical :: z
  z = x < y
end function
)"},
    {"wide_uvalue", R"(pure function wide_uvalue(x) result(y)
  integer(c_int64_t), intent(in) :: x
  $real :: y
  if (x >= 0) then
    y = real(x, $kind)
  else
    y = real(ior(ishft(x, -1), iand(x, 1_c_int64_t)), $kind)*2
  end if
end function
)"},
    {"wide_udiv", R"(pure function wide_udiv(x, y) result(z)
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
)"},
    {"wide_urem", R"(pure function wide_urem(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z
  z = 0
  if (y /= 0) z = wide_add(wide_add(x, not(wide_mul(wide_udiv(x, y), y))), 1_c_int64_t)
end function
)"},
    {"wide_div", R"(pure function wide_div(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z
  z = 0
  if (y == -1) then
    z = wide_add(not(x), 1_c_int64_t)
  else if (y /= 0) then
    z = x/y
  end if
end function
)"},
    {"wide_rem", R"(pure function wide_rem(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z
  z = 0
  if (y /= 0 .and. y /= -1) z = mod(x, y)
end function
)"},
    {"wide_and", R"(pure function wide_and(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z
  z = iand(x, y)
end function
)"},
    {"wide_or", R"(pure function wide_or(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z
  z = ior(x, y)
end function
)"},
    {"wide_xor", R"(pure function wide_xor(x, y) result(z)
  integer(c_int64_t), intent(in) :: x, y
  integer(c_int64_t) :: z
  z = ieor(x, y)
end function
)"},
    {"wide_shl", R"(pure function wide_shl(x, n) result(z)
  integer(c_int64_t), intent(in) :: x, n
  integer(c_int64_t) :: z
  z = ishft(x, int(ibits(n, 0, 6)))
end function
)"},
    {"wide_shr", R"(pure function wide_shr(x, n) result(z)
  integer(c_int64_t), intent(in) :: x, n
  integer(c_int64_t) :: z
  z = shifta(x, int(ibits(n, 0, 6)))
end function
)"},
    {"wide_ushr", R"(pure function wide_ushr(x, n) result(z)
  integer(c_int64_t), intent(in) :: x, n
  integer(c_int64_t) :: z
  z = ishft(x, -int(ibits(n, 0, 6)))
end function
)"},
};

static constexpr BridgeInteger integers[] = {
    {"int", "c_int"},
    {"long", "c_long"},
    {"long long", "c_long_long"},
    {"short", "c_short"},
    {"signed char", "c_signed_char"},
    {"unsigned int", "c_int", "int(int($value, c_long_long), $type)",
     "real(iand(int($value, c_long_long), 4294967295_c_long_long), c_double)"},
    // Values beyond a signed 64-bit integer are beyond the integers that a number holds anyway.
    {"unsigned long", "c_long"},
    {"unsigned long long", "c_long_long"},
    {"unsigned short", "c_short", "int(int($value, c_long_long), $type)",
     "real(iand(int($value, c_long_long), 65535_c_long_long), c_double)"},
    {"unsigned char", "c_signed_char", "int(int($value, c_long_long), $type)",
     "real(iand(int($value, c_long_long), 255_c_long_long), c_double)"},
    {"_Bool", "c_signed_char", "merge(1_c_signed_char, 0_c_signed_char, $value /= 0)"},
};

// Structures are passed by value, contiguous array sections without a copy.
static constexpr BridgeSyntax bridge = {
    .integers = integers,
    .to_integer = "int($value, $type)",
    .from_integer = "real($value, c_double)",
    .number = {"    real(c_double), value :: $p\n", "a($at)"},
    .integer = {"    integer($type), value :: $p\n", "$value"},
    .input = {"    real(c_double), intent(in) :: $p(*)\n", "a($at:$last)"},
    .output = {"    real(c_double), intent(inout) :: $p(*)\n", "r($at:$last)"},
    .object = {"    type(numbers_$count), value :: $p\n", "numbers_$count(a($at:$last))"},
    .copy = "  r($at:$last) = a($from:$from_last)\n",
    .number_result = "real(c_double)",
    .integer_result = "integer($type)",
    .object_result = "type(numbers_$count)",
    .no_store = "  $made\n",
    .number_store = "  r(1) = $made\n",
    .object_store = "  s = $made\n  r(1:$count) = s%m\n",
    .object_local = "  type(numbers_$count) :: s\n",
    .made = "c_$name($passed)",
    .made_without_result = "call c_$name($passed)",
    .structure = "type, bind(c) :: numbers_$count\n  real(c_double) :: m($count)\nend type\n",
    .import_structure = "    import :: numbers_$count\n",
    .begin = "! Functions of the program's libraries, with structures as what they consist of.\n",
    .declaration = "interface\n  function c_$name($names) bind(c, name='$c_name') result(y)\n"
                   "    use, intrinsic :: iso_c_binding\n$structures$declared    $result :: y\n"
                   "  end function\nend interface\n",
    .declaration_without_result = "interface\n  subroutine c_$name($names) bind(c, name='$c_name')\n"
                                  "    use, intrinsic :: iso_c_binding\n$structures$declared"
                                  "  end subroutine\nend interface\n",
    .bridge = "subroutine $name(a, r)\n  use, intrinsic :: iso_c_binding\n  real(c_double), intent(in) :: a(*)\n"
              "  real(c_double), intent(inout) :: r(*)\n$locals$copies${stored}"
              "end subroutine\n",
    .call = "call $name([$real :: $arguments], $array($first))",
};

static constexpr Companion beside[] = {{"_main.f90", module_main, "mainline"}};

static constexpr Word words[] = {
    {"kind", "c_double", "c_float"},
    {"f", "", "f"}, // behind the name of a function of C's library
    {"infinity", "transfer(int(z'7FF0000000000000', c_int64_t), 0.0d0)",
     "transfer(int(int(z'7F800000', c_int64_t)), 0.0)"},
    {"nan", "transfer(int(z'7FF8000000000000', c_int64_t), 0.0d0)", "transfer(int(int(z'7FC00000', c_int64_t)), 0.0)"},
};

Language language_fortran() {
  Language fortran;
  fortran.names = {keywords, true};
  fortran.comment = {"! ", "! ", ""};
  fortran.lines = {.width = 100, .continuation = " &", .base = 2};
  fortran.numbers = {.nan = "not_a_number",
                     .negative_nan = "not_a_number",
                     .infinity = "infinity",
                     .negative_infinity = "(-infinity)",
                     .exponent = "d",
                     .suffix = "d0",
                     .sign_binding = 11}; // a sign may not follow an operator
  fortran.number = {"real(c_double)", "0.0d0"};
  fortran.single = {.number = {"real(c_float)", "0.0"},
                    .numbers = {.nan = "not_a_number",
                                .negative_nan = "not_a_number",
                                .infinity = "infinity",
                                .negative_infinity = "(-infinity)",
                                .sign_binding = 11}};
  fortran.words = words;
  fortran.truth = {"logical", ".false."};
  fortran.wide = {"integer(c_int64_t)", "0_c_int64_t"};
  fortran.expressions = {
      .call_prefix = "c_",
      .operations = spellings,
      .element = "$array($index)",
      .first_index = 1,
      .yes = ".true.",
      .truth_as_number = "merge(1.0$suffix, 0.0$suffix, $x)",
      .small_integer = "${value}_c_int64_t",
      .large_integer = "int(z'$hex', c_int64_t)",
      .kept_integer = "transfer($element, 0_c_int64_t)",
      .table_index = "table_index($index, $extent)",
  };
  fortran.statements = {
      .first_declaration = "$type :: $name",
      .variable = "$name = $value",
      .constant = "$name = $value",
      .set = "$name = $value",
      .keep_integer = "$element = transfer($value, 0.0d0)",
      .array = "$real :: $name($count)",
      .zero_array = "$real :: $name($count)",
      .open = "if ($condition) then",
      .otherwise = "else",
      .close = "end if",
      .check = "if ($condition) then; guard = $number; return; end if",
  };
  fortran.functions = {
      .head = "${pure}subroutine $name($parameters$result)",
      .local_head = "${pure}subroutine $name($parameters$result)",
      .end = "end subroutine $name",
      .pure = "pure ",
      .no_result = "",
      .status = ", guard",
      .input = "$name",
      .output = "$name",
      .input_declaration = "$real, intent(in) :: $name(*)",
      .output_declaration = "$real, intent(inout) :: $name(*)",
      .success = "guard = 0",
      .status_declaration = "integer, intent(out) :: guard",
      .call = "call $name($arguments)",
      .checked_call = "call $name($arguments, guard)\nif (guard /= 0) return",
      .parts_store = true,
  };
  fortran.tables = {.begin = "$real, parameter :: $name($count) = [",
                    .end = "]",
                    .most_values = 700, // a statement has 255 continuation lines
                    .joined = "$real, parameter :: $name($count) = [$parts]\n"};
  fortran.externals = {.bridge = bridge};
  fortran.files = {
      .extension = ".f90",
      .kept_when = ", when compiled with\n-ffp-contract=off and without -ffast-math",
      .fast_when = " Any compiler flags.",
      .begin = module_begin,
      .helpers = helpers,
      .end = module_end,
      .companions = beside,
  };
  fortran.strings = {.quote = "'", .doubles_quotes = true, .most = 80, .joint = " // &\n        "};
  fortran.module = {
      .indent = 2,
      .begin = "module ${module}_kernel\n  use, intrinsic :: iso_c_binding, only: c_double, c_float, c_int64_t\n"
               "  implicit none\n  private :: c_double, c_float, c_int64_t\n\n",
      .size = "  integer, parameter :: $name = $value\n",
      .index_list = "  integer, parameter :: $name($count) = [integer :: $values]\n",
      .most_indices = 2000, // a statement has 255 continuation lines
      .long_index_list = "  integer, protected :: $name($count)\n  integer, private :: ${name}_at\n",
      .index_part = "  data ($name(${name}_at), ${name}_at = $first, $last) / $values /\n",
      .places = {.begin = "\n  ! The index of the first number of each $role.\n",
                 .object = "  integer, parameter :: ${role}_$name = $first\n"},
      .structure = {.begin =
                        "\n  ! The numbers of the $role: transfer makes one of the other. Extents are those of C in "
                        "reverse.\n  type :: ${role}_type\n",
                    .end = "  end type\n",
                    .object = "    $real :: $name$reversed_shape\n"},
      .functions = "\n",
      .contains = "contains\n\n",
      .guards_begin = "\n  ! The condition of a guard and its places in the source.\n"
                      "  function $guard_text(guard) result(text)\n    integer, intent(in) :: guard\n"
                      "    character(len=:), allocatable :: text\n    select case (guard)\n",
      .guard = "    case ($number)\n      text = $text\n",
      .guards_end = "    case default\n      text = ''\n    end select\n  end function $guard_text\n",
      .end = "end module ${module}_kernel\n",
      .main =
          R"(! Runs the kernel once and prints its outputs. Arguments replace the recorded inputs in order, then the parameters.
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
)",
      .call = "call $compute(given, constants, output)",
      .checked_call = R"(call $compute(given, constants, output, guard)
  if (guard /= 0) then
    write (error_unit, '(a, i0, a, a)') 'guard ', guard, ' does not hold: ', $guard_text(guard)
    stop 1, quiet=.true.
  end if)",
  };
  return fortran;
}

} // namespace symreal
