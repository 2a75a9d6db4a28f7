# Helpers of Python, and the code around functions, for python.toml. Marks: language_file.h.

# @helper either
def either(many, one):
    """A function of arrays, and of single numbers as the C library has it."""
    def function(*x):
        if ndarray in map(type, x):
            return many(*x)
        try:
            return float64(one(*x))
        except (ValueError, OverflowError):  # an infinity, or no number
            return float64(many(*x))
    return function


# @helper each
def each(one):
    """A function of single numbers for arrays, too."""
    return lambda *x: float64(numpy.frompyfunc(one, len(x), 1)(*x))


# @helper pick
def pick(condition, yes, no):
    if type(condition) is ndarray:
        return where(condition, yes, no)
    return yes if condition else no


# @helper select
def select(condition, yes, no):
    if type(condition) is ndarray:
        return where(condition, yes, no)
    return float64(yes if condition else no)


# @helpers
sqrt = numpy.sqrt
cbrt = either(numpy.cbrt, getattr(math, "cbrt", numpy.cbrt))
hypot = numpy.hypot
fmin = numpy.fmin
fmax = numpy.fmax

# @helper fdim
def fdim(x, y):
    return pick(x <= y, float64(0.0), x - y)


# @helpers
fmod = numpy.fmod

# @helper remainder
def _remainder(x, y):
    try:
        return math.remainder(x, y)
    except ValueError:
        return nan

remainder = each(_remainder)


# @helpers
floor = numpy.floor
ceil = numpy.ceil
trunc = numpy.trunc
rint = numpy.rint

# @helper round
def round(x):
    whole = numpy.trunc(x)
    return pick(abs(x - whole) >= 0.5, whole + numpy.sign(x), whole)


# @helpers
copysign = numpy.copysign
nextafter = numpy.nextafter

# @helper logb
def logb(x):
    exponent = numpy.frexp(x)[1] - 1.0
    return float64(pick(x == 0, float64(-inf), pick(numpy.isfinite(x), exponent, x*x)))


# @helper fma
def _fma(x, y, z):
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


# @helpers
sin = either(numpy.sin, math.sin)
cos = either(numpy.cos, math.cos)
tan = either(numpy.tan, math.tan)
asin = either(numpy.arcsin, math.asin)
acos = either(numpy.arccos, math.acos)
atan = either(numpy.arctan, math.atan)
atan2 = either(numpy.arctan2, math.atan2)
sinh = either(numpy.sinh, math.sinh)
cosh = either(numpy.cosh, math.cosh)
tanh = either(numpy.tanh, math.tanh)
asinh = either(numpy.arcsinh, math.asinh)
acosh = either(numpy.arccosh, math.acosh)
atanh = either(numpy.arctanh, math.atanh)
exp = either(numpy.exp, math.exp)
exp2 = either(numpy.exp2, getattr(math, "exp2", numpy.exp2))
expm1 = either(numpy.expm1, math.expm1)
log = either(numpy.log, math.log)
log2 = either(numpy.log2, math.log2)
log10 = either(numpy.log10, math.log10)
log1p = either(numpy.log1p, math.log1p)
pow = either(numpy.power, math.pow)
erf = each(math.erf)
erfc = each(math.erfc)

# @helper tgamma
def _tgamma(x):
    try:
        return math.gamma(x)
    except OverflowError:
        return inf
    except ValueError:
        return math.copysign(inf, x) if x == 0 else nan

tgamma = each(_tgamma)


# @helper lgamma
def _lgamma(x):
    try:
        return math.lgamma(x)
    except (ValueError, OverflowError):
        return inf

lgamma = each(_lgamma)


# @helper table_index
def table_index(index, extent):
    """An index outside of its table reads the nearest element."""
    return numpy.int64(pick(index > 0, numpy.fmin(index, extent - 1.0), float64(0.0)))


# @helper within64
def within64(x):
    return (x >= -9223372036854775808.0) & (x < 9223372036854775808.0)


# @helper to_int32
def to_int32(x):
    inside = (x > -2147483649.0) & (x < 2147483648.0)
    return float64(pick(inside, numpy.trunc(x) + 0.0, -2147483648.0))


# @helper to_int64
def to_int64(x):
    return float64(pick(within64(x), numpy.trunc(x) + 0.0, -9223372036854775808.0))


# @helper wide_int
def wide_int(x):
    return numpy.int64(to_int64(x)).view(uint64)


# @helper wide_uint
def wide_uint(x):
    return pick(x >= 9223372036854775808.0, wide_int(x - 9223372036854775808.0) ^ uint64(1 << 63), wide_int(x))


# @helper wide
def wide(high, low):
    return (wide_int(high) << uint64(32)) | (wide_int(low) & uint64(0xFFFFFFFF))


# @helper low_bits
def low_bits(x, width):
    return float64(wide_int(x) & uint64((1 << width) - 1))


# @helper wrapped
def wrapped(x, width):
    low = low_bits(x, width)
    return float64(pick(low >= 2.0**(width - 1), low - 2.0**width, low))


# @helper int_div
def int_div(x, y):
    return numpy.trunc(x/y) + 0.0


# @helper int_neg
def int_neg(x):
    return float64(pick(x == 0, 0.0, -x))


# @helper mul_uint32
def mul_uint32(x, y):
    return float64((wide_int(x)*wide_int(y)) & uint64(0xFFFFFFFF))


# @helper _magnitude
def _magnitude(x):
    return pick(x.view(int64) < 0, ~x + uint64(1), x)


# @helper wide_div
def wide_div(x, y):
    q = wide_udiv(_magnitude(x), _magnitude(y))
    return pick((x ^ y).view(int64) < 0, ~q + uint64(1), q)


# @helper wide_rem
def wide_rem(x, y):
    r = wide_urem(_magnitude(x), _magnitude(y))
    return pick(x.view(int64) < 0, ~r + uint64(1), r)


# @helper wide_udiv
def wide_udiv(x, y):
    return pick(y == 0, uint64(0), x//pick(y == 0, uint64(1), y))


# @helper wide_urem
def wide_urem(x, y):
    return pick(y == 0, uint64(0), x % pick(y == 0, uint64(1), y))


# @helper wide_and
def wide_and(x, y):
    return x & y


# @helper wide_or
def wide_or(x, y):
    return x | y


# @helper wide_xor
def wide_xor(x, y):
    return x ^ y


# @helper wide_shl
def wide_shl(x, n):
    return x << (n & uint64(63))


# @helper wide_shr
def wide_shr(x, n):
    return (x.view(int64) >> (n & uint64(63)).view(int64)).view(uint64)


# @helper wide_ushr
def wide_ushr(x, n):
    return x >> (n & uint64(63))


# @helper wide_less
def wide_less(x, y):
    return x.view(int64) < y.view(int64)


# @helper check
def check(fails, number):
    if numpy.any(fails):
        where_failed = numpy.nonzero(fails) if type(fails) is ndarray else ()
        raise GuardError(number, tuple(int(i[0]) for i in where_failed))


# @text externals.bridge.structure
class _Numbers$count(ctypes.Structure):
    _fields_ = [("m", ctypes.c_double*$count)]



# @text externals.bridge.begin
import ctypes

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


# @text externals.bridge.bridge
def $name(*a):
    function = _function("$c_name", $result, [$declared])
    r = (ctypes.c_double*max(1, $result_count))()
$copies$stored    return [float64(number) for number in r[:$result_count]]



# @text module.begin

import collections
import fractions
import math

import numpy
from numpy import float32, float64, inf, int64, nan, ndarray, uint64, where


# @text module.packing


def _is_masked(values):
    if isinstance(values, (list, tuple)):
        return any(map(_is_masked, values))
    return isinstance(values, numpy.ma.MaskedArray) and numpy.ma.is_masked(values)


def _exact(values, name):
    """The array of the values as doubles; TypeError where one of them is none."""
    if _is_masked(values):
        raise TypeError(f"{name} has masked elements, which have no value")
    array = numpy.asarray(values)
    if array.dtype == float64:
        return array
    kind, size = array.dtype.kind, array.dtype.itemsize
    if kind not in "biuf":
        raise TypeError(f"{name} has elements of type {array.dtype}, which is not one of real numbers")
    with numpy.errstate(over="ignore"):
        numbers = array.astype(float64)
    kept = True
    if kind in "iu" and size == 8:
        far = array[(array > 2**53) | (array < -2**53)]
        kept = all(int(float(one)) == one for one in far.tolist())
    elif size > 8:
        kept = numpy.array_equal(numbers, array, equal_nan=True)
    if not kept:
        raise TypeError(f"{name} has elements of type {array.dtype} that no double holds exactly")
    return numbers


def pack(objects, shapes):
    """The array of a tuple of objects: pack(Input(...), input_shapes). Leading axes are those of a batch."""
    names = getattr(objects, "_fields", range(len(shapes)))
    parts = [_exact(value, name) for value, name in zip(objects, names)]
    lead = [part.shape[:part.ndim - len(shape)] for part, shape in zip(parts, shapes)]
    for part, shape, name in zip(parts, shapes, names):
        if part.shape[part.ndim - len(shape):] != shape:
            raise ValueError(f"{name} has shape {part.shape}, which does not end in {shape}")
    lead = numpy.broadcast_shapes(*lead)
    flat = [numpy.broadcast_to(part, lead + shape).reshape(lead + (math.prod(shape),))
            for part, shape in zip(parts, shapes)]
    return numpy.concatenate(flat, axis=-1)


def unpack(numbers, shapes):
    """The list of objects of an array: Output(*unpack(output, output_shapes))."""
    objects, first = [], 0
    for shape in shapes:
        size = math.prod(shape)
        objects.append(numbers[..., first:first + size].reshape(numbers.shape[:-1] + shape))
        first += size
    return objects


def _checked(numbers, count, name):
    numbers = _exact(numbers, name)
    if numbers.shape[-1:] != (count,):
        raise ValueError(f"{name} has shape {numbers.shape}; its last axis must have {count} numbers")
    return numbers


# @text module.functions

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


def $preprocess(parameters=()):
    """The constants of compute, for parameters whose last axis has $parameters numbers. Once, and again whenever a
    parameter changes."""
    return _run(_$preprocess, _checked(parameters, $parameters, "parameters"))


def $compute(input, constants=None):
    """The outputs, $outputs numbers in the last axis, for inputs whose last axis has $inputs; the axes before it are a
    batch, and are broadcast against those of the constants."""
    constants = $preprocess() if constants is None else constants
    return _run(_$compute, _checked(input, $inputs, "input"), _checked(constants, $constants, "constants"))



# @text module.guards_begin
class GuardError(ValueError):
    """A guard does not hold: `number` is the first one that does not, `where` the index of the first such sample."""

    def __init__(self, number, where):
        self.number = number
        self.where = where
        super().__init__(f"guard {number} does not hold: {$guard_text(number)}")

    def __reduce__(self):
        """As pickle makes it again, in another process."""
        return type(self), (self.number, self.where), self.__dict__


def $guard_text(guard):
    """The condition of a guard and its places in the source."""
    text = [

# @text module.main

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
