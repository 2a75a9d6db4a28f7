"""Expressions of integer types, and indices."""
from .arithmetic import BOOL, DOUBLE, INT, LONG, SIZE, SPELLINGS, UNSIGNED, Integer, binary, common, converted, promoted, shifted
from .expression import (ADD, AND, CONDITION, EQUALITY, OR, POSTFIX, PRECEDENCE, PRIMARY, RELATION, UNARY, Expression, joined,
                         number)
from .generator import is_integer, production


def literal(g):
    value = g.among(0, 1, 2, 3, 4, 5, 7, 8, 10, 12, 100, 255, 1000, 30000)
    kind = g.among(INT, INT, INT, INT, UNSIGNED, LONG, SIZE) if g.has("unsigned") else INT
    text = {INT: f"{value}", UNSIGNED: f"{value}u", LONG: f"{value}L", SIZE: f"{value}UL"}[kind]
    if kind == INT and g.chance(0.15):
        text = f"0x{value:x}"
    if kind == INT and value and g.chance(0.25):
        return Expression(f"-{text}", UNARY, INT, -value, -value, False)
    return Expression(text, PRIMARY, kind, value, value, False)


def integer_leaf(g):
    things = g.variables(is_integer) + (g.arrays(is_integer) if g.chance(0.4) else [])
    if not things or g.chance(0.2):
        return literal(g)
    thing = g.random.choice(things[-4:] if g.chance(0.4) else things)
    if hasattr(thing, "size"):
        return indexed(g, thing)
    return Expression(thing.text, thing.binds, thing.type, thing.low, thing.high, thing.symbolic)


def integer(g, depth):
    if depth <= 0 or g.chance(0.2):
        return integer_leaf(g)
    return g.choose("integer", depth) or integer_leaf(g)


def as_operand(made):
    """An integer beside a double."""
    return Expression(made.text, made.binds, made.type, made.low, made.high, made.symbolic)


def bounded(g, made, low, high):
    """An integer within low (0 or less) to high, made of `made`."""
    if low <= made.low and made.high <= high:
        return made
    size = high + 1
    if made.low >= 0:
        if size & (size - 1) == 0 and g.chance(0.5):
            return Expression(f"{made.at(PRECEDENCE['&'])} & {high}", PRECEDENCE["&"], common(made.type, INT), 0, high,
                              made.symbolic)
        return Expression(f"{made.at(12)} % {size}", 12, common(made.type, INT), 0, high, made.symbolic)
    if low < 0 and size - 1 <= -low and promoted(made.type).signed:
        return Expression(f"{made.at(12)} % {size}", 12, common(made.type, INT), -high, high, made.symbolic)
    type = common(made.type, INT)
    if g.chance(0.5) and made.high < 2 ** 31 and made.type.signed:
        compared = made.at(RELATION)
        return Expression(f"({compared} < 0 ? 0 : {compared} > {high} ? {high} : {made.at(CONDITION)})", PRIMARY, type, 0, high,
                          made.symbolic)
    if size & (size - 1) == 0:
        return Expression(f"{made.at(PRECEDENCE['&'])} & {high}", PRECEDENCE["&"], type, 0, high, made.symbolic)
    return Expression(f"({made.at(12)} % {size} + {size}) % {size}", 12, type, 0, high, made.symbolic)


def index(g, size, symbolic_allowed=True):
    if size == 1:
        return Expression("0", PRIMARY, INT, 0, 0, False)
    fitting = [v for v in g.variables(is_integer) if v.low >= 0 and v.high < size]
    if fitting and g.chance(0.5):
        v = g.random.choice(fitting)
        if symbolic_allowed or not v.symbolic:
            return Expression(v.text, v.binds, v.type, v.low, v.high, v.symbolic)
    # Each bounded() repeats its text: an index in an index in an index would be a page long.
    if not g.has("computed_indices") or g.indices >= 2 or g.chance(0.4):
        k = g.whole(0, size - 1)
        return Expression(str(k), PRIMARY, INT, k, k, False)
    with g.only_plain(not symbolic_allowed or not g.has("symbolic_integers")):
        g.indices += 1
        made = bounded(g, integer(g, 1), 0, size - 1)
        g.indices -= 1
        return made


def indexed(g, array, symbolic_allowed=None):
    where = index(g, array.size, array.table if symbolic_allowed is None else symbolic_allowed)
    return Expression(f"{array.text}[{where.text}]", POSTFIX, array.type, array.low, array.high,
                      array.symbolic or where.symbolic)


@production("integer", 12)
def arithmetic(g, depth):
    operator = g.among("+", "-", "*", "+", "-", "/", "%")
    left, right = integer(g, depth - 1), integer(g, depth - 1)
    if operator in "/%":
        right = Expression(*(lambda k: (str(k), PRIMARY, INT, k, k, False))(g.among(2, 3, 5, 7, 10, 16)))
        if g.has("unsigned") and g.chance(0.2):
            right = Expression(f"{right.text}u", PRIMARY, UNSIGNED, right.low, right.high, False)
    return combined(operator, left, right)


@production("integer", 3, "bits")
def bits(g, depth):
    return combined(g.among("&", "|", "^"), integer(g, depth - 1), integer(g, depth - 1))


def combined(operator, left, right):
    type = common(left.type, right.type)
    if type.bits not in (32, 64):
        pass  # C's wide bit-fields
    a, b = converted(type, *left.interval), converted(type, *right.interval)
    interval = binary(operator, type, a, b)
    if interval is None:
        return None
    return Expression(joined(operator, left, right), PRECEDENCE[operator], type, *interval, left.symbolic or right.symbolic)


@production("integer", 2, "bits")
def shift(g, depth):
    left = integer(g, depth - 1)
    operator, amount = g.among("<<", ">>"), g.whole(0, 9)
    type = promoted(left.type)
    interval = shifted(operator, type, left.interval, amount)
    if interval is None or type.bits not in (32, 64):
        return None
    right = Expression(str(amount), PRIMARY, INT, amount, amount, False)
    return Expression(joined(operator, left, right), PRECEDENCE[operator], type, *interval, left.symbolic)


@production("integer", 2)
def unary(g, depth):
    inner = integer(g, depth - 1)
    type = promoted(inner.type)
    if g.has("bits") and g.chance(0.3):
        interval = (-inner.high - 1, -inner.low - 1) if type.signed else (type.low, type.high)
        return Expression(f"~{inner.at(POSTFIX)}", UNARY, type, *interval, inner.symbolic)
    interval = binary("-", type, (0, 0), inner.interval)
    if interval is None:
        return None
    return Expression(f"-{inner.at(POSTFIX)}", UNARY, type, *interval, inner.symbolic)


@production("integer", 3, "casts")
def cast(g, depth):
    inner = integer(g, depth - 1)
    type = g.random.choice(list(SPELLINGS))
    if not g.has("small_integers") and type.bits < 32 or not g.has("unsigned") and not type.signed:
        return None
    return cast_to(g, type, inner)


def cast_to(g, type, inner):
    spelling = g.random.choice(SPELLINGS[type])
    interval = converted(type, *inner.interval)
    if g.language == "cxx" and g.chance(0.6):
        return Expression(f"static_cast<{spelling}>({inner.text})", POSTFIX, type, *interval, inner.symbolic)
    return Expression(f"({spelling}){inner.at(UNARY)}", UNARY, type, *interval, inner.symbolic)


@production("integer", 5, "symbolic_integers")
def of_number(g, depth):
    """An integer that is made of a number."""
    if g.policy == "error" and not g.decides:
        return None
    from .numbers import tame_number
    inner = tame_number(g, depth - 1, g.among(20, 100, 30000))
    low, high = int(inner.low) - 1, int(inner.high) + 1
    types = [t for t in (INT, INT, INT, LONG, UNSIGNED, SIZE, Integer(16, True), Integer(8, False)) if t.holds(low, high)]
    type = g.random.choice(types)
    if not g.has("small_integers") and type.bits < 32 or not g.has("unsigned") and not type.signed or \
            not g.has("wide_integers") and type.bits == 64:
        return None
    how = g.among("cast", "cast", "floor", "lround")
    if how == "lround":
        if not g.has("wide_integers"):
            return None
        name = g.among("lround", "lrint", "llround")
        return Expression(f"{g.math(name)}({inner.text})", POSTFIX, LONG, low, high, inner.symbolic)
    if how == "floor":
        inner = number(f"{g.math(g.among('floor', 'ceil', 'rint', 'round'))}({inner.text})", POSTFIX, inner.interval, inner.symbolic)
    made = cast_to(g, type, Expression(inner.text, inner.binds, INT, 0, 0, inner.symbolic))
    made.low, made.high = max(low, type.low), min(high, type.high)
    return made


@production("integer", 3, "truth_values")
def truth(g, depth):
    from .conditions import condition
    if g.policy == "error" and not g.decides:
        with g.only_plain():
            return condition(g, depth - 1)
    return condition(g, depth - 1)


@production("integer", 2, "conditional")
def conditional(g, depth):
    from .conditions import condition
    test = condition(g, depth - 1)
    a, b = integer(g, depth - 1), integer(g, depth - 1)
    type = common(a.type, b.type)
    p, q = converted(type, *a.interval), converted(type, *b.interval)
    return Expression(f"{test.at(CONDITION + 1)} ? {a.text} : {b.at(CONDITION)}", CONDITION, type, min(p[0], q[0]),
                      max(p[1], q[1]), test.symbolic or a.symbolic or b.symbolic)


@production("integer", 2, "sizeof")
def size_of(g, depth):
    """C and C++ differ in some of these, and a kernel may depend on it."""
    texts = ["sizeof(double)", "sizeof(int)", "sizeof(float)", "sizeof(char)", "sizeof 1.0", "sizeof(long)", "sizeof(short[3])"]
    if g.has("sizeof_truth"):
        texts += ["sizeof('a')", "sizeof(1 == 1)", "sizeof(!0)"]
    doubles = g.variables(lambda v: v.type == DOUBLE)
    if doubles:
        texts += [f"sizeof({g.random.choice(doubles).text})"] + \
            ([f"sizeof({g.random.choice(doubles).text} > 1)"] if g.has("sizeof_truth") else [])
    return Expression(g.random.choice(texts), UNARY, SIZE, 1, 16, False)


@production("integer", 2, "characters")
def character(g, depth):
    text, value = g.among(("'a'", 97), ("'0'", 48), ("'\\n'", 10), ("'\\2'", 2), ("'Z'", 90))
    return Expression(text, PRIMARY, INT if g.language == "c" else Integer(8, True), value, value, False)


@production("integer", 2)
def absolute(g, depth):
    inner = integer(g, depth - 1)
    if promoted(inner.type) != INT or inner.low == INT.low:
        return None
    text = inner.text
    if g.language == "cxx":  # its overloads do not include the small types, nor bit-fields
        text = text if inner.binds == PRIMARY and inner.type == INT else f"static_cast<int>({text})"
    return Expression(f"{'std::' if g.language == 'cxx' else ''}abs({text})", POSTFIX, INT, 0, max(abs(inner.low), abs(inner.high)),
                      inner.symbolic)


@production("integer", 3, "helpers")
def call(g, depth):
    from .functions import called
    return called(g, depth, is_integer)
