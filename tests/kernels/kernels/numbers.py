"""Expressions of type double."""
from math import ceil, exp, floor, log, sqrt

from .arithmetic import DOUBLE, FLOAT, INT
from .expression import ADD, CONDITION, MULTIPLY, POSTFIX, PRIMARY, UNARY, Expression, joined, number
from .generator import is_double, production
from .integers import indexed, integer, integer_leaf, as_operand

CONSTANTS = ["0.5", "2.0", "1.5", "3.0", "0.1", "0.25", "10.", ".75", "1e-1", "2.5e0", "0x1.8p1", "1.0", "0.3", "7.25", "1.0/3"]


def constant(g, positive=False):
    text = g.among(*CONSTANTS)
    value = 1.0 / 3 if "/" in text else float.fromhex(text) if text.startswith("0x") else float(text)
    binds = MULTIPLY if "/" in text else PRIMARY
    if not positive and g.chance(0.2):
        return number(f"-({text})" if "/" in text else f"-{text}", UNARY, (-value, -value), False)
    return number(text, binds, (value, value), False)


def number_leaf(g):
    things = g.variables(is_double) + g.arrays(is_double)
    if not things or g.chance(0.15):
        return constant(g)
    thing = g.random.choice(things[-4:] if g.chance(0.4) else things)
    if hasattr(thing, "size"):
        return indexed(g, thing)
    return Expression(thing.text, thing.binds, DOUBLE, thing.low, thing.high, thing.symbolic)


def any_number(g, depth):
    """Also an infinity or a NaN, where the kernel may have them."""
    if depth <= 0 or g.chance(0.15):
        return number_leaf(g)
    return g.choose("number", depth) or number_leaf(g)


def tame_number(g, depth, limit=None):
    """One that is finite, whatever the inputs; within -limit to limit if that is given."""
    for _ in range(4):
        made = any_number(g, depth)
        if made.tame and (limit is None or max(abs(made.low), abs(made.high)) <= limit):
            return made
    bound = float(limit or g.among(4, 10, 100))
    if made.tame and g.chance(0.5):
        return number(f"{g.math('fmod')}({made.text}, {bound})", POSTFIX, (-bound, bound), made.symbolic)
    if not made.tame and g.mode == "finite":
        made = number(f"{g.math('sin')}({number_leaf_text(g)})", POSTFIX, (-1, 1), True)
        if bound >= 1:
            return made
    return number(f"{g.math('fmax')}(-{bound}, {g.math('fmin')}({bound}, {made.text}))", POSTFIX, (-bound, bound),
                  made.symbolic)


def number_leaf_text(g):
    tame = [v for v in g.variables(is_double) if v.low is not None]
    return g.random.choice(tame).text if tame else constant(g).text


def some_number(g, depth):
    return any_number(g, depth) if g.has("wild") and g.chance(0.5) else tame_number(g, depth)


def either(g, depth):
    """An operand of an operation whose other one is a double."""
    if g.has("integers") and g.chance(0.25):
        return as_operand(integer(g, depth))
    return any_number(g, depth)


@production("number", 14)
def sum_or_product(g, depth):
    operator = g.among("+", "-", "*", "+", "*")
    left, right = any_number(g, depth - 1), either(g, depth - 1)
    if g.chance(0.5):
        left, right = right, left
    interval = None
    if left.tame and right.tame:
        a, b = left.interval, right.interval
        if operator == "+":
            interval = a[0] + b[0], a[1] + b[1]
        elif operator == "-":
            interval = a[0] - b[1], a[1] - b[0]
        else:
            values = [p * q for p in a for q in b]
            interval = min(values), max(values)
    binds = ADD if operator in "+-" else MULTIPLY
    return number(joined(operator, left, right), binds, interval, left.symbolic or right.symbolic)


def away_from_zero(g, depth):
    inner = tame_number(g, depth - 1)
    shift = constant(g, positive=True)
    if g.chance(0.5):
        body = number(f"{g.math('fabs')}({inner.text})", POSTFIX, (0, max(abs(inner.low), abs(inner.high))), inner.symbolic)
    else:
        body = number(joined("*", inner, inner), MULTIPLY, (0, max(inner.low ** 2, inner.high ** 2)), inner.symbolic)
    pair = (shift, body) if g.chance(0.5) else (body, shift)
    interval = (shift.low, shift.high + body.high) if body.tame else None
    return number(joined("+", *pair), ADD, interval, inner.symbolic)


@production("number", 3)
def quotient(g, depth):
    left = either(g, depth - 1)
    if g.has("wild") and g.chance(0.3):
        right = any_number(g, depth - 1)
        if left.type != DOUBLE and right.type != DOUBLE:
            return None
        return number(joined("/", left, right), MULTIPLY, None, left.symbolic or right.symbolic)
    right = away_from_zero(g, depth) if g.chance(0.6) else constant(g)
    interval = None
    if left.tame and right.tame:
        values = [p / q for p in left.interval for q in right.interval]
        interval = min(values), max(values)
    return number(joined("/", left, right), MULTIPLY, interval, left.symbolic or right.symbolic)


@production("number", 2)
def negative(g, depth):
    inner = any_number(g, depth - 1)
    interval = (-inner.high, -inner.low) if inner.tame else None
    return number(f"-{inner.at(POSTFIX)}", UNARY, interval, inner.symbolic)


def monotone(function):
    return lambda low, high: (function(low), function(high))


# What each function makes of an interval; None: no number is known to come out.
ONE_ARGUMENT = {
    "sin": lambda low, high: (-1, 1), "cos": lambda low, high: (-1, 1), "tanh": lambda low, high: (-1, 1),
    "erf": lambda low, high: (-1, 1), "atan": lambda low, high: (-1.6, 1.6), "floor": monotone(floor),
    "ceil": monotone(ceil), "trunc": lambda low, high: (low - 1, high + 1), "rint": lambda low, high: (low - 1, high + 1),
    "round": lambda low, high: (low - 1, high + 1), "nearbyint": lambda low, high: (low - 1, high + 1),
    "fabs": lambda low, high: (0, max(abs(low), abs(high))),
    "sqrt": lambda low, high: (0, sqrt(high) + 1) if low >= 0 else None,
    "exp": lambda low, high: (0, exp(high) + 1) if high < 12 else None,
    "expm1": lambda low, high: (-1, exp(high) + 1) if high < 12 else None,
    "exp2": lambda low, high: (0, exp(high) + 1) if high < 12 else None,
    "log": lambda low, high: (log(low) - 1, log(high) + 1) if low > 0.01 else None,
    "log1p": lambda low, high: (log(1 + low) - 1, log(1 + high) + 1) if low > -0.9 else None,
    "cbrt": lambda low, high: (-1 - max(abs(low), abs(high)), 1 + max(abs(low), abs(high))),
    "asinh": lambda low, high: (-1 - max(abs(low), abs(high)), 1 + max(abs(low), abs(high))),
    "sinh": lambda low, high: (-exp(-low) - 1, exp(high) + 1) if -12 < low and high < 12 else None,
    "cosh": lambda low, high: (0, exp(max(abs(low), abs(high))) + 1) if -12 < low and high < 12 else None,
    "tan": lambda low, high: None, "log2": lambda low, high: None, "log10": lambda low, high: None,
    "acos": lambda low, high: (-0.1, 3.2) if -1 <= low and high <= 1 else None,
    "asin": lambda low, high: (-1.6, 1.6) if -1 <= low and high <= 1 else None,
}
COMMON = ["sin", "cos", "fabs", "sqrt", "exp", "atan", "floor"]


@production("number", 6, "math")
def function_of_one(g, depth):
    name = g.among(*COMMON) if g.chance(0.5) else g.random.choice(sorted(ONE_ARGUMENT))
    inner = any_number(g, depth - 1)
    if name == "sqrt" and g.chance(0.6):
        inner = away_from_zero(g, depth)
    interval = ONE_ARGUMENT[name](*inner.interval) if inner.tame else None
    if interval is None and not g.has("wild"):
        return None
    spelled = g.math(name)
    if name == "fabs" and g.language == "cxx" and g.chance(0.4):
        spelled = "std::abs"
    return number(f"{spelled}({inner.text})", POSTFIX, interval, inner.symbolic)


@production("number", 3, "math")
def function_of_two(g, depth):
    name = g.among("fmin", "fmax", "pow", "hypot", "fmod", "fma", "ldexp", "atan2", "copysign", "remainder", "fdim")
    a, b = any_number(g, depth - 1), any_number(g, depth - 1)
    symbolic = a.symbolic or b.symbolic
    spelled = g.math(name)
    both = a.tame and b.tame
    largest = max(abs(v) for v in a.interval + b.interval) if both else None
    if name in ("fmin", "fmax"):
        if not both and g.mode == "strict":
            return None  # which zero is the larger is left open
        return number(f"{spelled}({a.text}, {b.text})", POSTFIX, (-largest, largest) if both else None, symbolic) \
            if g.mode != "strict" else None
    if name == "pow":
        power = g.whole(-1, 4) if g.has("wild") else g.whole(0, 3)
        text = g.among(f"{power}", f"{power}.0", f"{power + 0.5}" if g.has("wild") else f"{power}")
        interval = None
        if a.tame and power >= 0 and "." not in text.replace(".0", ""):
            reach = max(1, abs(a.low), abs(a.high)) ** max(power, 1)
            interval = -reach, reach
        if interval is None and not g.has("wild"):
            return None
        if "." not in text and not g.has("math_integers"):
            text += ".0"
        return number(f"{spelled}({a.text}, {text})", POSTFIX, interval, a.symbolic)
    if name == "hypot":
        return number(f"{spelled}({a.text}, {b.text})", POSTFIX, (0, 2 * largest + 1) if both else None, symbolic)
    if name in ("fmod", "remainder"):
        c = constant(g, positive=True)
        return number(f"{spelled}({a.text}, {c.text})", POSTFIX, (-c.high, c.high) if a.tame else None, a.symbolic)
    if name == "fma":
        c = any_number(g, depth - 1)
        reach = largest ** 2 + max(abs(c.low), abs(c.high)) if both and c.tame else None
        return number(f"{spelled}({a.text}, {b.text}, {c.text})", POSTFIX, (-reach, reach) if reach is not None else None,
                      symbolic or c.symbolic)
    if name == "ldexp":
        k = g.whole(-3, 5)
        interval = (min(a.low * 2.0 ** k, a.low), max(a.high * 2.0 ** k, a.high)) if a.tame else None
        if interval and interval[0] > interval[1]:
            interval = None
        return number(f"{spelled}({a.text}, {k})", POSTFIX, None, a.symbolic)
    if name == "fdim":
        return number(f"{spelled}({a.text}, {b.text})", POSTFIX, (0, 2 * largest) if both else None, symbolic)
    if name == "copysign" and g.mode == "strict":
        if not b.tame:
            return None  # which sign a NaN has is left open
        return number(f"{spelled}({a.text}, {b.text})", POSTFIX, (-largest, largest) if both else None, symbolic)
    if name == "atan2":
        if g.mode != "strict":
            b = away_from_zero(g, depth)
        return number(f"{spelled}({a.text}, {b.text})", POSTFIX, (-3.2, 3.2) if a.tame and b.tame else None,
                      a.symbolic or b.symbolic)
    return None


@production("number", 2, "math_integers")
def function_of_integers(g, depth):
    """A function of the mathematical library that is given an integer."""
    inner = integer(g, depth - 1) if g.chance(0.6) else Expression(str(g.whole(1, 12)), PRIMARY, INT, 1, 12, False)
    if g.has("characters") and g.chance(0.15):
        inner = Expression(g.among("'\\2'", "'a'", "'0'"), PRIMARY, INT, 2, 97, False)
    if inner.type.bits == 64 or inner.type.truth:
        return None  # C++ has no such overload where long is not converted without loss, and what it has differs
    if g.language == "cxx" and (inner.type.bits != 32 or any(word in inner.text.lower() for word in ("mode", "kind"))):
        return None  # an enumerator is no int there
    name = g.random.choice(sorted(set(ONE_ARGUMENT) - {"nearbyint", "rint"}))
    low, high = float(inner.low), float(inner.high)
    interval = ONE_ARGUMENT[name](low, high)
    if interval is None and not g.has("wild"):
        return None
    return number(f"{g.math(name)}({inner.text})", POSTFIX, interval, inner.symbolic)


@production("number", 2, "integers")
def number_of_integer(g, depth):
    inner = integer(g, depth - 1)
    text = f"(double){inner.at(UNARY)}"
    if g.language == "cxx" and g.chance(0.6):
        text = g.among(f"static_cast<double>({inner.text})", f"double({inner.text})")
        return number(text, POSTFIX, inner.interval, inner.symbolic)
    return number(text, UNARY, inner.interval, inner.symbolic)


@production("number", 2, "conditional")
def conditional(g, depth):
    from .conditions import condition
    test = condition(g, depth - 1)
    a, b = any_number(g, depth - 1), any_number(g, depth - 1)
    if g.has("integers") and g.chance(0.1):
        b = as_operand(integer_leaf(g))
    interval = (min(a.low, b.low), max(a.high, b.high)) if a.tame and b.tame else None
    return number(f"{test.at(CONDITION + 1)} ? {a.text} : {b.at(CONDITION)}", CONDITION, interval,
                  test.symbolic or a.symbolic or b.symbolic)


@production("number", 1, "float")
def through_float(g, depth):
    inner = tame_number(g, depth - 1, 1e6)
    return number(f"(double)(float){inner.at(UNARY)}", UNARY, (inner.low - 1, inner.high + 1), inner.symbolic)


@production("number", 3, "helpers")
def call(g, depth):
    from .functions import called
    return called(g, depth, lambda function: function.type == DOUBLE)
