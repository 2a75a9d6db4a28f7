"""Functions of the mathematical library as values: in tables, arguments, members, compared and searched."""
from .arithmetic import DOUBLE, INT
from .expression import POSTFIX, Expression, number
from .generator import Function, Variable, production
from .integers import index
from .numbers import tame_number

NAMES = ["sin", "cos", "atan", "tanh", "fabs", "floor", "ceil", "cbrt", "erf"]
POINTER = "double (*{})(double)"
REACH = (-60.0, 60.0)  # what they make of -50 to 50


def value_of(g, name):
    """In C++ there are several of that name."""
    if g.language == "c":
        return name if g.chance(0.7) else f"&{name}"
    return f"static_cast<double (*)(double)>({g.among('std::', '', '::')}{name})"


def initialiser(g, name):
    return value_of(g, name) if g.language == "c" or g.chance(0.3) else g.among("std::", "") + name


@production("definition", 4, "function_values")
def table(g, depth):
    name, names = g.outer("laws"), g.random.sample(NAMES, g.whole(2, 4))
    g.define(f"static double (*{g.among('const ', 'const ', '')}{name}[{len(names)}])(double) = "
             f"{{{', '.join(initialiser(g, n) for n in names)}}};")
    g.function_tables.append((name, names))
    return True


@production("definition", 3, "function_values")
def applied(g, depth):
    """A function that is given one, and asks which it is."""
    name, asked = g.outer("apply"), g.among(*NAMES)
    body = g.among(f"f == {value_of(g, asked)} ? f(z) + 1 : f(z)", "f(z) - f(0.5)", f"(f != {value_of(g, asked)}) + f(z)", "0.5 * f(z)")
    g.define(f"static double {name}(double (*f)(double), double z) {{ return {body}; }}")
    g.function_takers.append(name)
    return True


@production("number", 4, "function_values")
def applied_to(g, depth):
    if not g.function_takers:
        return None
    inner, name = tame_number(g, depth - 1, 50), g.among(*NAMES)
    if g.function_tables and g.chance(0.5):
        table, names = g.random.choice(g.function_tables)
        with g.only_plain():
            text = f"{table}[{index(g, len(names)).text}]"
    else:
        text = initialiser(g, name)
    return number(f"{g.random.choice(g.function_takers)}({text}, {inner.text})", POSTFIX, (-130, 130), inner.symbolic)


@production("number", 4, "function_values")
def of_table(g, depth):
    if not g.function_tables:
        return None
    name, names = g.random.choice(g.function_tables)
    with g.only_plain():
        where = index(g, len(names))
    inner = tame_number(g, depth - 1, 50)
    text = f"{name}[{where.text}]({inner.text})" if g.chance(0.7) else f"(*{name}[{where.text}])({inner.text})"
    return number(text, POSTFIX, REACH, inner.symbolic)


@production("integer", 2, "function_values")
def equal(g, depth):
    if not g.function_tables:
        return None
    name, names = g.random.choice(g.function_tables)
    at, asked = g.whole(0, len(names) - 1), g.random.choice(names if g.chance(0.7) else NAMES)
    same = int(names[at] == asked)
    return Expression(f"(int)({name}[{at}] == {value_of(g, asked)})", 14, INT, same, same, False)


@production("statement", 4, "function_values")
def found(g, depth):
    if not g.function_tables:
        return None
    name, names = g.random.choice(g.function_tables)
    made, asked = g.local("at"), g.random.choice(names if g.chance(0.8) else NAMES)
    if g.language == "cxx" and g.chance(0.4):
        g.line(f"int {made} = (int)(std::find({name}, {name} + {len(names)}, {value_of(g, asked)}) - {name});")
    else:
        g.line(f"int {made} = 0;")
        g.line(f"while ({made} < {len(names)} && {name}[{made}] != {value_of(g, asked)}) {made}++;")
    at = names.index(asked) if asked in names else len(names)
    g.declare(Variable(made, INT, at, at, False, False))
    return True


@production("statement", 4, "function_values")
def pointer(g, depth):
    name, first, second = g.local("law"), g.among(*NAMES), g.among(*NAMES)
    how = g.whole(0, 4 if g.language == "cxx" else 2)
    from .conditions import condition
    if how == 0:
        with g.only_plain():
            test = condition(g, 1)
        g.line(f"double (*{name})(double) = {test.at(3)} ? {value_of(g, first)} : {value_of(g, second)};")
    elif how == 1:
        g.line(f"{g.among('static ', '')}double (*const {name})(double) = {initialiser(g, first)};")
    elif how == 2:
        g.line(f"struct {{ double (*of)(double); double k; }} {name} = {{{initialiser(g, first)}, 0.5}};")
        name = f"{name}.of"
    elif how == 3:
        g.line(f"std::function<double(double)> {name} = {value_of(g, first)};")
    else:
        g.line(f"auto {name} = [f = {value_of(g, first)}](double z) {{ return f(z) * 0.5; }};")
    g.declare(Function(name, [(DOUBLE, -50.0, 50.0)], DOUBLE, *REACH, True))
    if how in (0, 1) and g.chance(0.5):
        same = g.local("is")
        g.line(f"int {same} = {name} == {value_of(g, first)};")
        g.declare(Variable(same, INT, 0 if how == 0 else 1, 1, False, False))
    return True
