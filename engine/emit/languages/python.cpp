#include "engine/emit/languages/languages.h"
#include "engine/emit/languages/python_module.h"
#include "engine/emit/print/module.h"

#include <algorithm>
#include <array>

namespace symreal {

static constexpr auto keywords = std::to_array<std::string_view>(
    {"False",   "None",     "True",   "and",    "as",   "assert",  "async",    "await",   "bool",  "break",
     "class",   "continue", "def",    "del",    "elif", "else",    "except",   "finally", "float", "float32",
     "float64", "for",      "from",   "global", "if",   "import",  "in",       "inf",     "int64", "is",
     "lambda",  "len",      "list",   "math",   "nan",  "ndarray", "nonlocal", "not",     "numpy", "or",
     "pass",    "raise",    "return", "try",    "type", "uint64",  "where",    "while",   "with",  "yield"});

// Numbers are NumPy scalars or arrays, so that division by 0 gives an infinity and conditions select.
static constexpr OperationSpelling spellings[] = {
    {Op::abs, "abs($x)"},
    {Op::f32, "float64(float32($x))"},
    {Op::wrap_int8, "wrapped($x, 8)"},
    {Op::wrap_int16, "wrapped($x, 16)"},
    {Op::wrap_int32, "wrapped($x, 32)"},
    {Op::wrap_uint8, "low_bits($x, 8)"},
    {Op::wrap_uint16, "low_bits($x, 16)"},
    {Op::wrap_uint32, "low_bits($x, 32)"},
    {Op::wide_select, "pick($x, $y, $z)"},
    {Op::wide_value, "float64($x:15.view(int64))"},
    {Op::wide_uvalue, "float64($x)"},
    {Op::wide_low, "float64($x:12 & uint64(0xFFFFFFFF))"},
    {Op::logical_and, "$x:13 & $y:13", 8},
    {Op::logical_or, "$x:13 | $y:13", 6},
    {Op::logical_not, "~$x:15", 14},
    {Op::select, "select($x, $y, $z)"},
};

static constexpr Helper helpers[] = {
    {"either", R"(def either(many, one):
    """A function of arrays, and of single numbers as the C library has it."""
    def function(*x):
        if ndarray in map(type, x):
            return many(*x)
        try:
            return float64(one(*x))
        except (ValueError, OverflowError):  # an infinity, or no number
            return float64(many(*x))
    return function

)"},
    {"each", R"(def each(one):
    """A function of single numbers for arrays, too."""
    return lambda *x: float64(numpy.frompyfunc(one, len(x), 1)(*x))

)"},
    {"pick", R"(def pick(condition, yes, no):
    if type(condition) is ndarray:
        return where(condition, yes, no)
    return yes if condition else no

)"},
    {"select", R"(def select(condition, yes, no):
    if type(condition) is ndarray:
        return where(condition, yes, no)
    return float64(yes if condition else no)

)"},
    {"sqrt", "sqrt = numpy.sqrt\n"},
    {"cbrt", "cbrt = either(numpy.cbrt, getattr(math, \"cbrt\", numpy.cbrt))\n"},
    {"hypot", "hypot = numpy.hypot\n"},
    {"fmin", "fmin = numpy.fmin\n"},
    {"fmax", "fmax = numpy.fmax\n"},
    {"fdim", R"(def fdim(x, y):
    return pick(x <= y, float64(0.0), x - y)

)"},
    {"fmod", "fmod = numpy.fmod\n"},
    {"remainder", R"(def _remainder(x, y):
    try:
        return math.remainder(x, y)
    except ValueError:
        return nan

remainder = each(_remainder)

)"},
    {"floor", "floor = numpy.floor\n"},
    {"ceil", "ceil = numpy.ceil\n"},
    {"trunc", "trunc = numpy.trunc\n"},
    {"rint", "rint = numpy.rint\n"},
    {"round", R"(def round(x):
    whole = numpy.trunc(x)
    return pick(abs(x - whole) >= 0.5, whole + numpy.sign(x), whole)

)"},
    {"copysign", "copysign = numpy.copysign\n"},
    {"nextafter", "nextafter = numpy.nextafter\n"},
    {"logb", R"(def logb(x):
    exponent = numpy.frexp(x)[1] - 1.0
    return float64(pick(x == 0, float64(-inf), pick(numpy.isfinite(x), exponent, x*x)))

)"},
    {"fma", R"(def _fma(x, y, z):
    if not (math.isfinite(x) and math.isfinite(y)) or x == 0 or y == 0:
        return float64(x)*y + z
    if not math.isfinite(z):
        return z
    exact = fractions.Fraction(float(x))*fractions.Fraction(float(y)) + fractions.Fraction(float(z))
    if exact == 0:
        return 0.0
    try:
        return float(exact)
    except OverflowError:
        return inf if exact > 0 else -inf

fma = each(_fma)

)"},
    {"sin", "sin = either(numpy.sin, math.sin)\n"},
    {"cos", "cos = either(numpy.cos, math.cos)\n"},
    {"tan", "tan = either(numpy.tan, math.tan)\n"},
    {"asin", "asin = either(numpy.arcsin, math.asin)\n"},
    {"acos", "acos = either(numpy.arccos, math.acos)\n"},
    {"atan", "atan = either(numpy.arctan, math.atan)\n"},
    {"atan2", "atan2 = either(numpy.arctan2, math.atan2)\n"},
    {"sinh", "sinh = either(numpy.sinh, math.sinh)\n"},
    {"cosh", "cosh = either(numpy.cosh, math.cosh)\n"},
    {"tanh", "tanh = either(numpy.tanh, math.tanh)\n"},
    {"asinh", "asinh = either(numpy.arcsinh, math.asinh)\n"},
    {"acosh", "acosh = either(numpy.arccosh, math.acosh)\n"},
    {"atanh", "atanh = either(numpy.arctanh, math.atanh)\n"},
    {"exp", "exp = either(numpy.exp, math.exp)\n"},
    {"exp2", "exp2 = either(numpy.exp2, getattr(math, \"exp2\", numpy.exp2))\n"},
    {"expm1", "expm1 = either(numpy.expm1, math.expm1)\n"},
    {"log", "log = either(numpy.log, math.log)\n"},
    {"log2", "log2 = either(numpy.log2, math.log2)\n"},
    {"log10", "log10 = either(numpy.log10, math.log10)\n"},
    {"log1p", "log1p = either(numpy.log1p, math.log1p)\n"},
    {"pow", "pow = either(numpy.power, math.pow)\n"},
    {"erf", "erf = each(math.erf)\n"},
    {"erfc", "erfc = each(math.erfc)\n"},
    {"tgamma", R"(def _tgamma(x):
    try:
        return math.gamma(x)
    except OverflowError:
        return inf
    except ValueError:
        return math.copysign(inf, x) if x == 0 else nan

tgamma = each(_tgamma)

)"},
    {"lgamma", R"(def _lgamma(x):
    try:
        return math.lgamma(x)
    except (ValueError, OverflowError):
        return inf

lgamma = each(_lgamma)

)"},
    {"table_index", R"(def table_index(index, extent):
    """An index outside of its table reads the nearest element."""
    return numpy.int64(pick(index > 0, numpy.fmin(index, extent - 1.0), float64(0.0)))

)"},
    {"within64", R"(def within64(x):
    return (x >= -9223372036854775808.0) & (x < 9223372036854775808.0)

)"},
    {"to_int32", R"(def to_int32(x):
    inside = (x > -2147483649.0) & (x < 2147483648.0)
    return float64(pick(inside, numpy.trunc(x) + 0.0, -2147483648.0))

)"},
    {"to_int64", R"(def to_int64(x):
    return float64(pick(within64(x), numpy.trunc(x) + 0.0, -9223372036854775808.0))

)"},
    {"wide_int", R"(def wide_int(x):
    return numpy.int64(to_int64(x)).view(uint64)

)"},
    {"wide_uint", R"(def wide_uint(x):
    return pick(x >= 9223372036854775808.0, wide_int(x - 9223372036854775808.0) ^ uint64(1 << 63), wide_int(x))

)"},
    {"wide", R"(def wide(high, low):
    return (wide_int(high) << uint64(32)) | (wide_int(low) & uint64(0xFFFFFFFF))

)"},
    {"low_bits", R"(def low_bits(x, width):
    return float64(wide_int(x) & uint64((1 << width) - 1))

)"},
    {"wrapped", R"(def wrapped(x, width):
    low = low_bits(x, width)
    return float64(pick(low >= 2.0**(width - 1), low - 2.0**width, low))

)"},
    {"int_div", R"(def int_div(x, y):
    return numpy.trunc(x/y) + 0.0

)"},
    {"int_neg", R"(def int_neg(x):
    return float64(pick(x == 0, 0.0, -x))

)"},
    {"mul_uint32", R"(def mul_uint32(x, y):
    return float64((wide_int(x)*wide_int(y)) & uint64(0xFFFFFFFF))

)"},
    {"_magnitude", R"(def _magnitude(x):
    return pick(x.view(int64) < 0, ~x + uint64(1), x)

)"},
    {"wide_div", R"(def wide_div(x, y):
    q = wide_udiv(_magnitude(x), _magnitude(y))
    return pick((x ^ y).view(int64) < 0, ~q + uint64(1), q)

)"},
    {"wide_rem", R"(def wide_rem(x, y):
    r = wide_urem(_magnitude(x), _magnitude(y))
    return pick(x.view(int64) < 0, ~r + uint64(1), r)

)"},
    {"wide_udiv", R"(def wide_udiv(x, y):
    return pick(y == 0, uint64(0), x//pick(y == 0, uint64(1), y))

)"},
    {"wide_urem", R"(def wide_urem(x, y):
    return pick(y == 0, uint64(0), x % pick(y == 0, uint64(1), y))

)"},
    {"wide_and", "def wide_and(x, y):\n    return x & y\n\n"},
    {"wide_or", "def wide_or(x, y):\n    return x | y\n\n"},
    {"wide_xor", "def wide_xor(x, y):\n    return x ^ y\n\n"},
    {"wide_shl", "def wide_shl(x, n):\n    return x << (n & uint64(63))\n\n"},
    {"wide_shr", "def wide_shr(x, n):\n    return (x.view(int64) >> (n & uint64(63)).view(int64)).view(uint64)\n\n"},
    {"wide_ushr", "def wide_ushr(x, n):\n    return x >> (n & uint64(63))\n\n"},
    {"wide_less", "def wide_less(x, y):\n    return x.view(int64) < y.view(int64)\n\n"},
    {"check", R"(def check(fails, number):
    if numpy.any(fails):
        where_failed = numpy.nonzero(fails) if type(fails) is ndarray else ()
        raise GuardError(number, tuple(int(i[0]) for i in where_failed))

)"},
};

static constexpr BridgeInteger integers[] = {
    {"int", "int"},
    {"long", "long"},
    {"long long", "longlong"},
    {"short", "short"},
    {"signed char", "byte"},
    {"char", "byte"},
    {"unsigned int", "uint"},
    {"unsigned long", "ulong"},
    {"unsigned long long", "ulonglong"},
    {"unsigned short", "ushort"},
    {"unsigned char", "ubyte"},
    {"_Bool", "bool"},
};

// Calls process one sample after the other, in program order.
static constexpr BridgeSyntax bridge = {
    .integers = integers,
    .to_integer = "int($value)",
    .from_integer = "$value",
    .number = {"ctypes.c_double, ", "a[$at]"},
    .integer = {"ctypes.c_$type, ", "$value"},
    .input = {"ctypes.c_void_p, ", "(ctypes.c_double*$count)(*a[$at:$next])"},
    .output = {"ctypes.c_void_p, ", "ctypes.byref(r, 8*$at)"},
    .object = {"_Numbers$count, ", "_Numbers$count((ctypes.c_double*$count)(*a[$at:$next]))"},
    .copy = "    r[$at:$next] = a[$from:$from_next]\n",
    .no_result = "None",
    .number_result = "ctypes.c_double",
    .integer_result = "ctypes.c_$type",
    .object_result = "_Numbers$count",
    .no_store = "    $made\n",
    .number_store = "    r[0] = $made\n",
    .object_store = "    r[0:$count] = list($made.m)\n",
    .made = "function($passed)",
    .structure = "class _Numbers$count(ctypes.Structure):\n    _fields_ = [(\"m\", ctypes.c_double*$count)]\n\n\n",
    .begin = R"(import ctypes

# Functions of the program's libraries, with structs as what they consist of.
_library = None


def use_library(path):
    """Has external functions called in this library, a path or name as ctypes.CDLL takes it; before, among those that the
    process has loaded."""
    global _library
    _library = ctypes.CDLL(path)


def _function(name, result, parameters):
    if _library is None:
        use_library(None)
    function = _library[name]
    function.restype, function.argtypes = result, parameters
    return function


def _in_turn(run):
    """Functions of libraries take one sample after the other."""
    def each(function, *arrays):
        shape = numpy.broadcast_shapes(*(numbers.shape[:-1] for numbers in arrays))
        if not shape:
            return run(function, *arrays)
        count = $constant_count if function is _$preprocess else $output_count
        results = numpy.empty(shape + (count,))
        samples = [numpy.broadcast_to(numbers, shape + numbers.shape[-1:]) for numbers in arrays]
        for k in numpy.ndindex(shape):
            try:
                results[k] = run(function, *(numbers[k] for numbers in samples))
            except ValueError as error:
                error.where = k
                raise
        return results
    return each


_run = _in_turn(_run)

)",
    .bridge = "def $name(*a):\n    function = _function(\"$c_name\", $result, [$declared])\n"
              "    r = (ctypes.c_double*max(1, $result_count))()\n$copies$stored"
              "    return [float64(number) for number in r[:$result_count]]\n\n\n",
    .call = "$array[$first:$next] = $name($arguments)",
};

static constexpr Companion beside[] = {{"_main.py", module_main, "mainline"}};
static std::string functions_text() {
  std::string text(python_arrays);
  text += R"(
def _rows(numbers):
    return list(numpy.moveaxis(numbers, -1, 0)) if numbers.ndim > 1 else list(numbers), numbers.shape[:-1]


def _run(function, *arrays):
    rows, shapes = zip(*map(_rows, arrays))
    shape = numpy.broadcast_shapes(*shapes)
    with numpy.errstate(all="ignore"):
        values = function(*rows)
    result = numpy.empty(shape + (len(values),))
    for k, value in enumerate(values):
        result[..., k] = value
    return result

)";
  text += python_preprocess;
  text += R"(    return _run(_$preprocess, _checked(parameters, $parameters, "parameters"))


def $compute(input, constants=None):
)";
  text += python_places;
  text += R"("""
    constants = $preprocess() if constants is None else constants
    return _run(_$compute, _checked(input, $inputs, "input"), _checked(constants, $constants, "constants"))


)";
  return text;
}

Language language_python() {
  static std::string const functions = functions_text();
  Language python;
  python.names = {keywords, false};
  python.comment = {"# ", "# ", ""};
  python.lines = {.width = 100, .least = 60, .continuation = " \\", .step = 4};
  python.numbers = {"nan", "nan", "inf", "-inf"};
  python.number = {"", "float64(0.0)"};
  python.expressions = {
      .operations = spellings,
      .element = "$array[$index]",
      .yes = "numpy.bool_(True)",
      .truth_as_number = "float64($x)",
      .small_integer = "uint64($value)",
      .large_integer = "uint64($value)",
      .kept_integer = "$element.view(uint64)",
      .table_index = "table_index($index, $extent)",
  };
  python.statements = {
      .constant = "$name = $value",
      .set = "$name = $value",
      .keep_integer = "$element = $value.view(float64)",
      .array = "$name = [None]*$count",
      .zero_array = "$name = [None]*$count",
      .check = "check($condition, $number)",
  };
  python.functions = {
      .head = "def _$name($parameters):",
      .local_head = "def _$name($parameters):",
      .end = "\n",
      .input = "$name",
      .local_output = "$name",
      .results = "$name = [None]*$count",
      .finish = "return $name",
      .local_finish = "return",
      .call = "_$name($arguments)",
      .checked_call = "_$name($arguments)",
      .most_statements = 2000,
  };
  python.tables = {.begin = "$name = numpy.array([", .end = "])"};
  python.externals = {.bridge = bridge};
  python.files = {
      .extension = ".py",
      .kept_when = ", but for functions of\nNumPy on arrays, which have a unit or two in the last place of their own",
      .begin = module_begin,
      .helpers = helpers,
      .end = module_end,
      .companions = beside,
  };
  python.strings = {.quote = "\"", .escaped = "\"\\"};
  python.has_blocks = false;
  python.module = {
      .is_named_after_file = true,
      .begin = R"(
import collections
import fractions
import math

import numpy
from numpy import float32, float64, inf, int64, nan, ndarray, uint64, where

)",
      .size = "$name = $value\n",
      .index_list = "$name = numpy.array([$values], dtype=numpy.intp)\n",
      .places = {.begin = "${role}_shapes = [", .end = "]\n", .object = "($extents_comma)", .separator = ", "},
      .structure = {.begin =
                        "\n# The objects of the $role, with their shapes.\n$Role = collections.namedtuple(\"$Role\", "
                        "[",
                    .end = "], rename=True)\n",
                    .object = "\"$name\"",
                    .separator = ", "},
      .functions = functions,
      .guards_begin = python_guards_begin,
      .guard = python_guard,
      .guards_end = python_guards_end,
      .main = R"(
"""Runs the kernel once and prints its outputs. Arguments replace the recorded inputs in order, then the parameters."""
import sys
from math import inf, nan

import $base as kernel

values = [$all_values]
names = [$labels]
given = [float(argument) for argument in sys.argv[1:]][:len(values)]
values[:len(given)] = given
$call
for name, value in zip(names, output):
    print(f"{name} = {float(value)!r}")
)",
      .call = "constants = kernel.$preprocess(values[$inputs:])\noutput = kernel.$compute(values[:$inputs], constants)",
      .checked_call = R"(constants = kernel.$preprocess(values[$inputs:])
try:
    output = kernel.$compute(values[:$inputs], constants)
except kernel.GuardError as error:
    sys.exit(str(error)))",
  };
  return python;
}

} // namespace symreal
