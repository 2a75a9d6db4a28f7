"""Statements: declarations, assignments, branches, loops."""
from .arithmetic import BOOL, DOUBLE, INT, SPELLINGS, UNSIGNED, Integer, converted
from .conditions import condition
from .expression import ADD, CONDITION, MULTIPLY, UNARY, Expression
from .generator import Array, Block, Variable, is_double, is_integer, production
from .integers import bounded, index, indexed, integer
from .numbers import any_number, some_number, tame_number


def statements(g, count, depth):
    for _ in range(count):
        g.choose("statement", depth)


def integer_type(g):
    choices = [INT] * 4
    if g.has("unsigned"):
        choices += [UNSIGNED, UNSIGNED, Integer(64, False)]
    if g.has("wide_integers"):
        choices += [Integer(64, True)]
    if g.has("small_integers"):
        choices += [Integer(16, True), Integer(8, True)] + ([Integer(16, False), Integer(8, False)] if g.has("unsigned") else [])
    return g.random.choice(choices)


def spelled(g, type):
    if type.truth:
        return "_Bool" if g.language == "c" else "bool"
    return g.random.choice(SPELLINGS[type])


def fitting(g, made, type, low, high):
    """The integer as a value for an object of `type` that holds low to high."""
    if converted(type, *made.interval)[0] >= low and converted(type, *made.interval)[1] <= high:
        return made
    return bounded(g, made, low, high)


def fitting_number(g, depth, low, high):
    if low is None:
        return some_number(g, depth)
    made = tame_number(g, depth, min(abs(low), abs(high)))
    return made


@production("statement", 6)
def declare_number(g, depth):
    name = g.local(g.among("a", "s", "v", "t"))
    made = some_number(g, 3)
    qualifier = "const " if g.chance(0.2) else ""
    type = "auto" if g.language == "cxx" and g.chance(0.2) and made.type == DOUBLE else "double"
    reach = None
    if made.tame:
        reach = max(10.0, 2 * max(abs(made.low), abs(made.high)))
    g.line(f"{qualifier}{type} {name} = {made.text};")
    g.declare(Variable(name, DOUBLE, made.low if qualifier else -reach if reach else None,
                       made.high if qualifier else reach, True, not qualifier))
    return True


@production("statement", 5, "integers")
def declare_integer(g, depth):
    plain = g.chance(0.4)
    type = integer_type(g)
    name = g.local(g.among("i", "n", "k", "u" if not type.signed else "m"))
    with g.only_plain(plain):
        made = integer(g, 2)
    low, high = (type.low, type.high) if not type.signed or type.bits < 32 else (-1000, 1000)
    made = fitting(g, made, type, low, high)
    if g.language == "cxx" and g.chance(0.3):
        made = Expression(f"static_cast<{spelled(g, type)}>({made.text})", 15, type, 0, 0, made.symbolic)
        text = f"auto {name} = {made.text};"
    else:
        text = f"{spelled(g, type)} {name} = {made.text};"
    qualifier = g.chance(0.2)
    g.line(("const " if qualifier else "") + text)
    g.declare(Variable(name, type, low, high, not plain, not qualifier, plain))
    return True


@production("statement", 3, "implicit_conversions")
def declare_integer_of_number(g, depth):
    if g.policy == "error" and not g.decides:
        return None
    name = g.local("q")
    made = tame_number(g, 2, 1000)
    g.line(f"int {name} = {made.text};")
    g.declare(Variable(name, INT, -1000, 1000, True))
    return True


@production("statement", 2, "truth_values")
def declare_truth(g, depth):
    name = g.local("on")
    test = condition(g, 2)
    if g.policy == "error" and not g.decides and test.symbolic:
        return None
    g.line(f"{spelled(g, BOOL) if g.chance(0.6) else 'int'} {name} = {test.text};")
    g.declare(Variable(name, INT, 0, 1, test.symbolic, False))
    return True


@production("statement", 4, "arrays")
def declare_array(g, depth):
    name, size = g.local("w"), g.whole(2, 5)
    if g.has("integers") and g.chance(0.25):
        values = [bounded(g, integer(g, 1), -100, 100) for _ in range(size)]
        plain = not any(v.symbolic for v in values)
        texts = [v.text if v.type == INT else f"(int){v.at(UNARY)}" for v in values]
        g.line(f"int {name}[{size}] = {{{', '.join(texts)}}};")
        g.declare(Array(name, size, INT, -100, 100, not plain, not plain))
        return True
    reach = None if g.has("wild") and g.chance(0.4) else 100.0
    values = [fitting_number(g, 2, reach and -reach, reach) for _ in range(size)]
    if g.chance(0.2):
        values = values[:1]
    g.line(f"double {name}[{size}] = {{{', '.join(v.text for v in values)}}};")
    g.declare(Array(name, size, DOUBLE, reach and -reach, reach, True))
    return True


@production("statement", 3, "pointers")
def declare_pointer(g, depth):
    arrays = [a for a in g.arrays(is_double) if a.size >= 3]
    if not arrays:
        return None
    array = g.random.choice(arrays)
    offset = g.whole(0, array.size - 2)
    name = g.local("p")
    start = g.among(f"{array.text} + {offset}", f"&{array.text}[{offset}]") if offset else array.text
    if array.container:
        start = f"&{array.text}[{offset}]"
    g.line(f"{'' if array.writable else 'const '}double *{name} = {start};")
    g.declare(Array(name, array.size - offset, DOUBLE, array.low, array.high, True, array.writable))
    g.declare(Variable(f"*{name}", DOUBLE, array.low, array.high, True, array.writable, False, UNARY))
    return True


def target(g):
    things = g.variables(is_double, writable=True) + g.arrays(is_double, writable=True)
    return g.random.choice(things) if things else None


@production("statement", 10)
def assign_number(g, depth):
    thing = target(g)
    if thing is None:
        return None
    text = thing.text if isinstance(thing, Variable) else \
        indexed(g, thing, g.has("symbolic_index_writes")).text
    if thing.low is None and g.chance(0.5):
        operator = g.among("+", "-", "*", "/")
        made = any_number(g, 2) if g.has("wild") or operator != "/" else None
        if made is None:
            return None
        if not g.has("wild") and operator == "*":
            return None
        g.line(f"{text} {operator}= {made.text};")
        return True
    if thing.low is not None and g.chance(0.3) and not g.loops:
        # A value within half of the bounds, then one step.
        half = min(abs(thing.low), abs(thing.high)) / 2
        if half >= 1:
            first, second = tame_number(g, 2, half), tame_number(g, 1, half)
            g.line(f"{text} = {first.text};")
            g.line(f"{text} {g.among('+', '-')}= {second.text};")
            return True
    g.line(f"{text} = {fitting_number(g, 3, thing.low, thing.high).text};")
    return True


@production("statement", 5, "integers")
def assign_integer(g, depth):
    things = g.variables(is_integer, writable=True)
    if not things:
        return None
    v = g.random.choice(things)
    with g.only_plain(v.plain):
        if v.type.low == v.low and v.type.high == v.high and v.type.bits != 1 and g.chance(0.5):
            # It wraps, so anything may happen to it, as long as no signed promotion overflows.
            if not v.type.signed and v.type.bits >= 32:
                operator, made = g.among("+", "-", "*", "^", "&", "|"), integer(g, 1)
                if operator in "^&|" and not g.has("bits"):
                    return None
                if made.type.bits > v.type.bits and made.type.signed and operator == "*":
                    return None
                if made.type.bits > v.type.bits and made.type.signed and operator in "+-" and \
                        max(abs(made.low), abs(made.high)) > 2 ** 40:
                    return None
                g.line(f"{v.text} {operator}= {made.text};")
            else:
                if g.chance(0.5):
                    g.line(f"{v.text} {g.among('+', '-')}= {bounded(g, integer(g, 1), -100, 100).text};")
                else:
                    g.line(g.among(f"{v.text}++;", f"--{v.text};"))
            return True
        g.line(f"{v.text} = {fitting(g, integer(g, 2), v.type, v.low, v.high).text};")
    return True


@production("statement", 5, "branches")
def branch(g, depth):
    if depth <= 0:
        return None
    test = condition(g, 2)
    with g.block(f"if ({test.text}) {{") as made:
        statements(g, g.whole(1, 2), depth - 1)
    if g.chance(0.5):
        made.footer = None
        if g.chance(0.3):
            with g.block(f"}} else if ({condition(g, 1).text}) {{", None):
                statements(g, 1, depth - 1)
        with g.block("} else {"):
            statements(g, g.whole(1, 2), depth - 1)
    return True


@production("statement", 2, "switch")
def switch(g, depth):
    if depth <= 0 or g.policy == "error" and not g.decides and not g.variables(lambda v: is_integer(v) and not v.symbolic):
        return None
    with g.only_plain(not g.has("symbolic_integers") or g.policy == "error" and not g.decides):
        made = bounded(g, integer(g, 1), 0, 3)
    if made.type.bits != 32:
        return None
    with g.block(f"switch ({made.text}) {{"):
        for k in range(g.whole(1, 3)):
            with g.block(f"case {k}: {{", "}"):
                statements(g, 1, depth - 1)
                if g.chance(0.8):
                    g.line("break;")
        if g.chance(0.7):
            with g.block("default: {", "}"):
                statements(g, 1, depth - 1)
    return True


@production("statement", 4, "loops")
def loop(g, depth):
    if depth <= 0 or g.loops >= 2:
        return None
    g.loops += 1
    made = g.random.choice([counted, counted, counted_down, while_loop])(g, depth)
    g.loops -= 1
    return made


def bound(g, largest):
    """How often a loop runs: a number, or an integer of the kernel."""
    if g.has("computed_bounds") and g.chance(0.5):
        symbolic = g.has("symbolic_bounds") and (g.policy != "error" or g.decides)
        with g.only_plain(not symbolic):
            return bounded(g, integer(g, 1), 0, largest)
    return Expression(str(largest), 16, INT, largest, largest, False)


def counted(g, depth):
    name, end = g.local("j"), bound(g, g.whole(2, 4))
    type = g.among("int", "int", "size_t", "unsigned", "short") if g.has("unsigned") else "int"
    kind = {"int": INT, "size_t": Integer(64, False), "unsigned": UNSIGNED, "short": Integer(16, True)}[type]
    step = g.among("++{}", "{}++", "{} += 2")
    with g.block(f"for ({type} {name} = 0; {name} < {end.at(ADD)}; {step.format(name)}) {{"):
        g.declare(Variable(name, kind, 0, max(end.high - 1, 0), end.symbolic, False))
        statements(g, g.whole(1, 3), depth - 1)
        if g.has("exits") and g.chance(0.15):
            exit_loop(g)
    return True


def exit_loop(g):
    test = condition(g, 1)
    g.line(f"if ({test.text}) {g.among('break', 'continue')};")


def counted_down(g, depth):
    name, end = g.local("j"), bound(g, g.whole(2, 4))
    with g.block(f"for (int {name} = (int)({end.text}); {name} > 0; {name}--) {{"):
        g.declare(Variable(name, INT, 1, max(end.high, 1), end.symbolic, False))
        statements(g, g.whole(1, 3), depth - 1)
    return True


def while_loop(g, depth):
    name, end = g.local("j"), bound(g, g.whole(2, 4))
    g.line(f"int {name} = {end.text};")
    counter = Variable(name, INT, 0, end.high, end.symbolic, False)
    if g.chance(0.5):
        with g.block(f"while ({name}-- > 0) {{"):
            g.declare(counter)
            statements(g, g.whole(1, 3), depth - 1)
    else:
        with g.block("do {", f"}} while (--{name} > 0);"):
            g.declare(counter)
            counter.low = min(0, counter.low)
            statements(g, g.whole(1, 3), depth - 1)
    return True


@production("statement", 2, "returns")
def early_return(g, depth):
    if g.returns is None or g.loops and g.chance(0.7):
        return None
    test = condition(g, 2)
    if g.in_helper:
        made = g.result(g)
        g.returns.append(made)
        text = made.text
    else:
        text = g.kernel_result(g) if g.kernel_result else ""
    g.line(f"if ({test.text}) return{' ' + text if text else ''};")
    return True
