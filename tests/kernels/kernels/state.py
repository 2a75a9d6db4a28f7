"""What outlives a call: declared as it should be, or deliberately not, which the tool must then refuse."""
from .arithmetic import DOUBLE, INT
from .expression import ADD
from .generator import Array, Variable, production
from .integers import bounded, integer
from .interface import section
from .numbers import tame_number


def declare_state(g, made):
    """Adds state of file scope to the interface."""
    if g.has("state"):
        for _ in range(g.whole(0, 2)):
            g.random.choice([number_in_and_out, array_in_and_out, written_first, scratch])(g, made)
    if g.has("undeclared_state") and g.chance(0.5):
        g.random.choice([undeclared_number, undeclared_counter, local_static, undeclared_gain])(g, made)


def bounds(made):
    return (made.low, made.high) if made.tame else (None, None)


def number_in_and_out(g, made):
    name = g.outer("last")
    g.define(f"static double {name};")
    made.inputs.append((name, [name]))
    made.outputs.append((name, [name]))
    g.declare(Variable(name, DOUBLE, *bounds(made), True))


def array_in_and_out(g, made):
    name, size = g.outer("line"), g.whole(2, 3)
    g.define(f"static double {name}[{size}];")
    made.inputs.append(section(name, size))
    made.outputs.append(section(name, size))
    g.declare(Array(name, size, DOUBLE, *bounds(made), True))


def written_first(g, made):
    name = g.outer("seen")
    g.define(f"static double {name} = 1.5;")
    made.outputs.append((name, [name]))
    g.line(f"{name} = fmax(-100.0, fmin(100.0, {tame_number(g, 1, 100).at(ADD)} + {g.inputs[0].text}));")
    g.declare(Variable(name, DOUBLE, -100.0, 100.0, True, False))


def scratch(g, made):
    name, size = g.outer("work"), g.whole(2, 3)
    g.define(f"static double {name}[{size}];")
    made.clauses.append(f"scratch({name}[0:{size}])")
    for k in range(size):
        g.line(f"{name}[{k}] = {tame_number(g, 1, 100).text};")
    g.declare(Array(name, size, DOUBLE, -100.0, 100.0, True))


def undeclared_number(g, made):
    name = g.outer("held")
    g.define(f"static double {name} = 1.0;")
    made.hidden.append(name)
    if g.chance(0.5):
        g.line(f"{name} = {g.among('3.0', '-0.5', tame_number(g, 1, 10).text)};")
    else:
        test = tame_number(g, 1, 100)
        g.line(f"if ({test.text} < 1) {name} = 0.0; else {name} = 2.5;")
    if g.chance(0.7):
        g.declare(Variable(name, DOUBLE, -10.0, 10.0, True))


def undeclared_counter(g, made):
    name = g.outer("calls")
    g.define(f"static int {name};")
    made.hidden.append(name)
    g.line(g.among(f"{name}++;", f"{name} = {name} + 1 & 3;", f"{name} ^= 1;"))
    if g.chance(0.7):
        g.declare(Variable(name, INT, -10 ** 6, 10 ** 6, False, False))


def local_static(g, made):
    name = g.local("st")
    g.line(f"static double {name} = 0.25;")
    g.line(f"{name} = {tame_number(g, 1, 10).text};" if g.chance(0.3) else f"{name} = -{name};")
    g.declare(Variable(name, DOUBLE, -10.0, 10.0, True))


def undeclared_gain(g, made):
    """Another function of the program sets it; the kernel reads it only."""
    name = g.outer("gain")
    g.define(f"static double {name} = 1.25;")
    g.define(f"void {name}_set(double value) {{ {name} = value; }}")
    made.clauses += [f"constant({name})"] if g.chance(0.5) else []
    g.declare(Variable(name, DOUBLE, -10.0, 10.0, True, False))
