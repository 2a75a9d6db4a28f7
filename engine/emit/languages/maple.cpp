#include "engine/emit/languages/languages.h"
#include "engine/emit/print/module.h"

#include <algorithm>
#include <array>

namespace symreal {

static constexpr auto keywords = std::to_array<std::string_view>(
    {"Catalan", "D",    "Digits",   "FAIL",        "I",       "O",    "Pi",    "abs",   "and",       "assuming",
     "break",   "by",   "catch",    "description", "do",      "done", "elif",  "else",  "end",       "error",
     "evalb",   "exp",  "export",   "false",       "finally", "for",  "from",  "gamma", "global",    "if",
     "implies", "in",   "infinity", "intersect",   "local",   "max",  "min",   "minus", "mod",       "module",
     "next",    "not",  "od",       "option",      "options", "or",   "proc",  "quit",  "read",      "return",
     "save",    "stop", "subset",   "then",        "to",      "true", "trunc", "try",   "undefined", "union",
     "use",     "uses", "while",    "xor"});
static_assert(std::ranges::is_sorted(keywords));

// Procedures have the option hfloat: numbers are hardware floats. A sign must come first or be in parentheses.
static constexpr OperationSpelling spellings[] = {
    {Op::neg, "-$x:14", 11},
    {Op::abs, "abs($x)"},
    {Op::sqrt, "in_reals(sqrt($x))"},
    {Op::cbrt, "surd($x, 3)"},
    {Op::fmin, "min($x, $y)"},
    {Op::fmax, "max($x, $y)"},
    {Op::remainder, "frem($x, $y)"},
    {Op::floor, "1.0*floor($x)", 13},
    {Op::ceil, "1.0*ceil($x)", 13},
    {Op::trunc, "1.0*trunc($x)", 13},
    {Op::round, "1.0*round($x)", 13},
    {Op::copysign, "CopySign($x, $y)"},
    {Op::nextafter, "NextAfter($x, $y)"},
    {Op::logb, "1.0*ilog2($x)", 13},
    {Op::f32, "Vector(1, [$x], datatype = float[4])[1]"},
    {Op::wrap_int8, "wrapped($x, 8)"},
    {Op::wrap_int16, "wrapped($x, 16)"},
    {Op::wrap_int32, "wrapped($x, 32)"},
    {Op::wrap_uint8, "low_bits($x, 8)"},
    {Op::wrap_uint16, "low_bits($x, 16)"},
    {Op::wrap_uint32, "low_bits($x, 32)"},
    {Op::wide_add, "modp($x + $y, 2^64)"},
    {Op::wide_sub, "modp($x - $y:13, 2^64)"},
    {Op::wide_mul, "modp($x:13*$y:14, 2^64)"},
    {Op::wide_select, "`if`($x, $y, $z)"},
    {Op::wide_uless, "evalb($x < $y)"},
    {Op::wide_equal, "evalb($x = $y)"},
    {Op::wide_value, "1.0*as_signed($x)", 13},
    {Op::wide_uvalue, "1.0*$x:14", 13},
    {Op::wide_low, "1.0*modp($x, 2^32)", 13},
    {Op::asin, "in_reals(arcsin($x))"},
    {Op::acos, "in_reals(arccos($x))"},
    {Op::atan, "arctan($x)"},
    {Op::atan2, "arctan($x, $y)"},
    {Op::asinh, "arcsinh($x)"},
    {Op::acosh, "in_reals(arccosh($x))"},
    {Op::atanh, "in_reals(arctanh($x))"},
    {Op::exp2, "2.0^($x)"},
    {Op::log, "in_reals(ln($x))"},
    {Op::log2, "in_reals(log[2]($x))"},
    {Op::log10, "in_reals(log10($x))"},
    {Op::pow, "in_reals(($x)^($y))"},
    {Op::tgamma, "GAMMA($x)"},
    {Op::lgamma, "Re(lnGAMMA($x))"},
    {Op::lt, "evalb($x < $y)"},
    {Op::le, "evalb($x <= $y)"},
    {Op::gt, "evalb($x > $y)"},
    {Op::ge, "evalb($x >= $y)"},
    {Op::eq, "evalb($x = $y)"},
    {Op::ne, "evalb($x <> $y)"},
    {Op::logical_and, "$x:12 and $y:12", 5},
    {Op::logical_or, "$x:12 or $y:12", 4},
    {Op::logical_not, "not $x:14", 6},
    {Op::select, "`if`($x, $y, $z)"},
};

// A product that is rounded once would need more digits than hardware floats have.
static constexpr Op lacks[] = {Op::fma};

static constexpr Helper helpers[] = {
    {"in_reals", R"(in_reals := proc(x)
  if type(x, numeric) then x else Float(undefined) end if
end proc:
)"},
    {"hypot", R"(hypot := proc(x, y) option hfloat;
  local a, b;
  a := max(abs(x), abs(y));
  b := min(abs(x), abs(y));
  if a = 0 then a else a*sqrt(1.0 + (b/a)^2) end if
end proc:
)"},
    {"fdim", R"(fdim := proc(x, y) option hfloat;
  if x <= y then 0.0 else x - y end if
end proc:
)"},
    {"fmod", R"(fmod := proc(x, y) option hfloat;
  local r;
  r := frem(abs(x), abs(y));
  if r < 0 then r := r + abs(y) end if;
  CopySign(r, x)
end proc:
)"},
    {"rint", R"(rint := proc(x) option hfloat;
  if abs(x - trunc(x)) = 0.5 then 2.0*round(x/2) else 1.0*round(x) end if
end proc:
)"},
    {"expm1", R"(expm1 := proc(x) option hfloat;
  if abs(x) < 1 then 2.0*exp(x/2)*sinh(x/2) else exp(x) - 1 end if
end proc:
)"},
    {"log1p", R"(log1p := proc(x) option hfloat;
  in_reals(`if`(abs(x) < 0.5, 2.0*arctanh(x/(2 + x)), ln(1 + x)))
end proc:
)"},
    {"table_index", R"(# An index outside of its table reads the nearest element.
table_index := proc(index, extent)
  if not evalb(index > 0) then 0 elif index < extent then trunc(index) else extent - 1 end if
end proc:
)"},
    {"as_signed", R"(as_signed := proc(x)
  if x >= 2^63 then x - 2^64 else x end if
end proc:
)"},
    {"whole", R"(whole := proc(x)
  if x >= -9223372036854775808 and x < 9223372036854775808 then trunc(x) else -9223372036854775808 end if
end proc:
)"},
    {"to_int32", R"(to_int32 := proc(x)
  if x > -2147483649 and x < 2147483648 then 1.0*trunc(x) else -2147483648.0 end if
end proc:
)"},
    {"to_int64", "to_int64 := proc(x)\n  1.0*whole(x)\nend proc:\n"},
    {"low_bits", "low_bits := proc(x, width)\n  1.0*modp(whole(x), 2^width)\nend proc:\n"},
    {"wrapped", R"(wrapped := proc(x, width)
  local low;
  low := modp(whole(x), 2^width);
  if low >= 2^(width - 1) then low := low - 2^width end if;
  1.0*low
end proc:
)"},
    {"wide_int", "wide_int := proc(x)\n  modp(whole(x), 2^64)\nend proc:\n"},
    {"wide_uint", R"(wide_uint := proc(x)
  if x >= 2^63 and x < 2^64 then trunc(x) else wide_int(x) end if
end proc:
)"},
    {"wide", "wide := proc(high, low)\n  modp(whole(high)*2^32, 2^64) + modp(whole(low), 2^32)\nend proc:\n"},
    {"int_div", "int_div := proc(x, y) option hfloat;\n  1.0*trunc(x/y)\nend proc:\n"},
    {"int_neg", "int_neg := proc(x) option hfloat;\n  if x = 0 then 0.0 else -x end if\nend proc:\n"},
    {"mul_uint32", "mul_uint32 := proc(x, y)\n  1.0*modp(whole(x)*whole(y), 2^32)\nend proc:\n"},
    {"wide_div", R"(wide_div := proc(x, y)
  if y = 0 then 0 else modp(iquo(as_signed(x), as_signed(y)), 2^64) end if
end proc:
)"},
    {"wide_rem", R"(wide_rem := proc(x, y)
  if y = 0 then 0 else modp(irem(as_signed(x), as_signed(y)), 2^64) end if
end proc:
)"},
    {"wide_udiv", "wide_udiv := proc(x, y)\n  if y = 0 then 0 else iquo(x, y) end if\nend proc:\n"},
    {"wide_urem", "wide_urem := proc(x, y)\n  if y = 0 then 0 else irem(x, y) end if\nend proc:\n"},
    {"wide_and", "wide_and := proc(x, y)\n  Bits:-And(x, y)\nend proc:\n"},
    {"wide_or", "wide_or := proc(x, y)\n  Bits:-Or(x, y)\nend proc:\n"},
    {"wide_xor", "wide_xor := proc(x, y)\n  Bits:-Xor(x, y)\nend proc:\n"},
    {"wide_shl", "wide_shl := proc(x, n)\n  modp(x*2^modp(n, 64), 2^64)\nend proc:\n"},
    {"wide_shr", "wide_shr := proc(x, n)\n  modp(floor(as_signed(x)/2^modp(n, 64)), 2^64)\nend proc:\n"},
    {"wide_ushr", "wide_ushr := proc(x, n)\n  iquo(x, 2^modp(n, 64))\nend proc:\n"},
    {"wide_less", "wide_less := proc(x, y)\n  evalb(as_signed(x) < as_signed(y))\nend proc:\n"},
};

static constexpr Companion beside[] = {{"_main.mpl", module_main, "mainline"}};

Language language_maple() {
  Language maple;
  maple.names = {.keywords = keywords};
  maple.comment = {"# ", "# ", ""};
  maple.lines = {.width = 100, .least = 60};
  maple.numbers = {.nan = "Float(undefined)",
                   .negative_nan = "Float(undefined)",
                   .infinity = "Float(infinity)",
                   .negative_infinity = "Float(-infinity)",
                   .sign_binding = 11};
  maple.number = {"", "0.0"};
  maple.truth = {"", "false"};
  maple.wide = {"", "0"};
  maple.expressions = {
      .operations = spellings,
      .element = "$array[$index]",
      .first_index = 1,
      .yes = "true",
      .truth_as_number = "`if`($x, 1.0, 0.0)",
      .small_integer = "$value",
      .large_integer = "$value",
      .kept_integer = "$element",
      .table_index = "table_index($index, $extent)",
  };
  maple.statements = {
      .variable = "$name := $value;",
      .constant = "$name := $value;",
      .set = "$name := $value;",
      .keep_integer = "$element := $value;",
      .array = "$name := Array(1 .. $count);",
      .zero_array = "$name := Array(1 .. $count);",
      .open = "if $condition then",
      .otherwise = "else",
      .close = "end if;",
      .check = "if $condition then error \"guard %1 does not hold\", $number end if;",
  };
  maple.functions = {
      .head = "$name := proc($parameters) option hfloat;",
      .local_head = "$name := proc($parameters) option hfloat;",
      .end = "end proc:\n",
      .input = "$name",
      .local_output = "$name",
      .locals = "local $names;",
      .results = "$name := Vector($count, datatype = float[8]);",
      .finish = "return $name;",
      .local_finish = "return;",
      .call = "$name($arguments);",
      .checked_call = "$name($arguments);",
  };
  maple.tables = {.begin = "$name := Array([", .end = "]):"};
  maple.lacks = lacks;
  maple.files = {
      .extension = ".mpl",
      .kept_when = ", but for functions of\nMaple's own, where Digits is at most 15",
      .begin = module_begin,
      .helpers = helpers,
      .end = module_end,
      .companions = beside,
  };
  maple.strings = {.quote = "\"", .escaped = "\"\\"};
  maple.module = {
      .begin = "\n",
      .size = "$name := $value:\n",
      .index_list = "$name := [$values]:\n",
      .places = {.begin = "\n# The index of the first number of each $role, and its extents.\n${role}_at := table([\n",
                 .end = "\n]):\n",
                 .object = "  \"$name\" = [$first, [$extents]]",
                 .separator = ",\n"},
      .functions = "\n",
      .guards_begin =
          "# The condition of a guard and its places in the source.\n$guard_text := proc(guard)\n  return [\n",
      .guard = "    $text,\n",
      .guards_end = "    \"\"][guard];\nend proc:\n",
      .main = R"(
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
)",
      .call = "output := $compute(numbers[1 .. $inputs], $preprocess(numbers[$inputs + 1 .. $inputs + $parameters])):",
      .checked_call = R"(try
  output := $compute(numbers[1 .. $inputs], $preprocess(numbers[$inputs + 1 .. $inputs + $parameters])):
catch "guard":
  printf("guard %d does not hold: %s\n", lastexception[3], $guard_text(lastexception[3]));
  `quit`(1);
end try:)",
  };
  return maple;
}

} // namespace symreal
