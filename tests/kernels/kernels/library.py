"""What C++'s library offers: algorithms, containers, complex numbers."""
from .arithmetic import DOUBLE, INT
from .expression import ADD, POSTFIX, Expression, number
from .generator import Array, Variable, is_double, production
from .integers import bounded, integer
from .numbers import any_number, constant, tame_number


@production("number", 5, "algorithms", "cxx")
def extreme(g, depth):
    how = g.among("min", "max", "clamp", "max of list")
    if how == "clamp":
        a = tame_number(g, depth - 1)
        low, high = sorted(g.random.sample([-3, -1, 0, 2, 5, 9], 2))
        return number(f"std::clamp({a.text}, {low}.0, {high}.0)", POSTFIX, (low, high), a.symbolic)
    a, b = tame_number(g, depth - 1), tame_number(g, depth - 1)
    if a.type != DOUBLE or b.type != DOUBLE:
        return None
    interval = min(a.low, b.low), max(a.high, b.high)
    symbolic = a.symbolic or b.symbolic
    if how == "max of list":
        return number(f"std::{g.among('min', 'max')}({{{a.text}, {b.text}, 1.5}})", POSTFIX,
                      (min(interval[0], 1.5), max(interval[1], 1.5)), symbolic)
    return number(f"std::{g.among('min', 'max')}({a.text}, {b.text})", POSTFIX, interval, symbolic)


@production("integer", 2, "algorithms", "cxx")
def extreme_of_integers(g, depth):
    i, j = bounded(g, integer(g, depth - 1), -50, 50), bounded(g, integer(g, depth - 1), -50, 50)
    return Expression(f"std::{g.among('min', 'max')}<int>({i.text}, {j.text})", POSTFIX, INT, -50, 50, i.symbolic or j.symbolic)


@production("statement", 4, "algorithms", "cxx")
def algorithm(g, depth):
    arrays = [a for a in g.arrays(is_double, writable=True) if a.low is not None]
    if not arrays:
        return None
    a = g.random.choice(arrays)
    first, last = f"&{a.text}[0]", f"&{a.text}[0] + {a.size}"
    if a.container and g.chance(0.7):
        first, last = f"{a.text}.begin()", f"{a.text}.end()"
    made, reach = g.local("acc"), max(abs(a.low), abs(a.high))
    how = g.whole(0, 6)
    if how == 0:
        g.line(f"double {made} = std::accumulate({first}, {last}, 0.0);")
        g.declare(Variable(made, DOUBLE, -reach * a.size - 1, reach * a.size + 1, True))
    elif how == 1:
        g.line(f"double {made} = std::inner_product({first}, {last}, {first}, {constant(g).text});")
        g.declare(Variable(made, DOUBLE, -reach ** 2 * a.size - 11, reach ** 2 * a.size + 11, True))
    elif how == 2:
        g.line(f"std::{g.among('reverse', 'reverse', 'sort')}({first}, {last});"
               if g.policy != "error" or g.decides else f"std::reverse({first}, {last});")
    elif how == 3:
        g.line(f"std::swap({a.text}[0], {a.text}[{a.size - 1}]);")
    elif how == 4:
        g.line(f"std::fill({first}, {last}, {tame_number(g, 1, reach).text});")
    elif how == 5:
        g.line(f"std::transform({first}, {last}, {first}, [](double q) {{ return q * {g.among('0.5', '0.25', '-1')}; }});")
    else:
        g.line(f"for (double &q : std::array<double, 2>{{1.0, 2.0}}) {a.text}[0] = q * 0.25;" if reach > 1 else f"{a.text}[0] = 0;")
    return True


@production("statement", 4, "containers", "cxx")
def container(g, depth):
    name, size = g.local("list"), g.whole(2, 4)
    how = g.whole(0, 3)
    if how == 0:
        g.line(f"std::vector<double> {name}({size}, {tame_number(g, 1, 100).text});")
    elif how == 1:
        g.line(f"std::vector<double> {name};")
        with g.block(f"for (int at = 0; at < {size}; at++) {{"):
            g.line(f"{name}.push_back({tame_number(g, 1, 50).text} + at);")
    elif how == 2:
        g.line(f"std::array<double, {size}> {name} = {{{', '.join(tame_number(g, 1, 100).text for _ in range(size))}}};")
    else:
        first, second = g.local("first"), g.local("second")
        g.line(f"auto [{first}, {second}] = std::make_pair({tame_number(g, 1, 100).text}, {g.whole(1, 5)});")
        g.declare(Variable(first, DOUBLE, -100.0, 100.0, True, False))
        g.declare(Variable(second, INT, 1, 5, False, False))
        return True
    g.declare(Array(name, size, DOUBLE, -100.0, 100.0, True, container=True))
    if g.chance(0.5):
        total = g.local("total")
        g.line(f"double {total} = 0;")
        g.line(f"for ({g.among('double', 'auto', 'auto const &')} q : {name}) {total} += q{g.among('', ' * q', ' * 0.5')};")
        g.declare(Variable(total, DOUBLE, -1e5, 1e5, True, False))
    return True


@production("statement", 5, "complex", "cxx")
def complex_number(g, depth):
    if g.in_helper:
        return None  # gcc computes what the library makes of constants, and rounds it in a way of its own
    z, w = g.local("z"), g.local("z")
    a, b = f"{tame_number(g, 1, 50).at(ADD)} + {g.random.choice(g.inputs).text}", tame_number(g, 1, 50).text
    g.line(f"std::complex<double> {z}({a}, {b});")
    other = f"std::complex<double>({tame_number(g, 1, 5).text}, {g.among('1.5', '-0.5', '2.0')})"
    step = g.among(f"{z} * {z}", f"{z} + {other}", f"{z} * {other} - {z}", f"std::conj({z}) * 2.0", f"{z} / {other}", f"std::exp({z} * 0.05)",
                   f"std::sqrt({z})", f"2.0 / ({z} + 60.0)", f"std::polar(2.0, {a})", f"std::pow({z} + 51.0, 2.0)",
                   f"std::pow({z} + 60.0, 1.0 / 3.0)", f"std::pow({z}, 2)", f"-{z}", f"std::sin({z} * 0.05)", f"std::log({z} + 60.0)")
    g.line(f"std::complex<double> {w} = {step};")
    if g.chance(0.3):
        g.line(f"{w} {g.among('*=', '+=', '-=')} {g.among(z, '0.5')};")
    for text in g.random.sample([f"{w}.real()", f"{w}.imag()", f"std::norm({w})", f"std::abs({w})", f"std::arg({w} + 1e3)"], 2):
        g.declare(Variable(text, DOUBLE, None, None, True, False))
    made = g.local("re")
    g.line(f"double {made} = {w}.{g.among('real', 'imag')}();")
    g.declare(Variable(made, DOUBLE, None, None, True))
    return True
