"""How a kernel is called: its signature and pragma, the call that is recorded, and the call that the harness makes.

`items` are what the harness moves between its flat arrays and the program: inputs and parameters before a call, outputs
before it (what the caller left there) and after it.
"""
from dataclasses import dataclass, field

from .arithmetic import DOUBLE
from .expression import POSTFIX, Expression
from .generator import Array, Variable
from .returned import returned_objects


@dataclass
class Interface:
    result: str = "void"
    parameters: list = field(default_factory=list)   # "double const *x"
    arguments: list = field(default_factory=list)
    inputs: list = field(default_factory=list)       # (text in the pragma, elements as the harness writes them)
    values: list = field(default_factory=list)       # parameters of the pragma, likewise
    outputs: list = field(default_factory=list)
    clauses: list = field(default_factory=list)      # constant(...), scratch(...)
    objects: list = field(default_factory=list)      # declarations of what is passed
    hidden: list = field(default_factory=list)       # objects that no annotation names
    plains: list = field(default_factory=list)       # arguments and members that are baked in (plain.py)
    returned: object = None                          # what an object is returned as (returned.py)
    low: float = -4.0
    high: float = 4.0
    tame: bool = True


def section(text, size):
    return f"{text}[0:{size}]", [f"{text}[{k}]" for k in range(size)]


def make_interface(g):
    """Declares what the kernel gets in the innermost scope, and says what it writes: (text, is it an array)."""
    made = Interface()
    made.tame = not (g.has("wild") and not g.has("integers") and g.chance(0.3))
    made.low, made.high = g.among((-4.0, 4.0), (-4.0, 4.0), (-10.0, 10.0), (0.5, 8.0), (-1.0, 1.0), (0.0, 100.0), (-100.0, 100.0))
    forms = [pointers, pointers, scalars, in_place, structs]
    if g.language == "cxx":
        forms += [vectors, arrays, references]
    if g.has("returned_objects") and g.chance(0.7):
        forms = [returned_objects]
    written = g.random.choice(forms)(g, made)
    if g.has("parameters") and g.chance(0.4):
        name = g.local("c")
        made.parameters.append(f"double {name}")
        made.arguments.append(name)
        made.objects.append(f"double {name} = 0;")
        made.values.append((name, [name]))
        number(g, made, name)
    if g.has("integer_arguments") and g.chance(0.3):
        name, value = g.local("n"), g.whole(2, 4)
        made.parameters.append(f"{g.among('int', 'unsigned', 'long') if g.has('unsigned') else 'int'} {name}")
        made.arguments.append(str(value))
        made.clauses.append(f"constant({name})")
        from .arithmetic import INT, LONG, UNSIGNED
        type = {"int": INT, "unsigned": UNSIGNED, "long": LONG}[made.parameters[-1].split()[0]]
        g.declare(Variable(name, type, value, value, False, False))
    return made, written


def interval(made):
    return (made.low, made.high) if made.tame else (None, None)


def number(g, made, text, writable=False, binds=16):
    g.declare(Variable(text, DOUBLE, *interval(made), True, writable, binds=binds))
    g.inputs.append(Expression(text, binds, DOUBLE, *interval(made), True))


def array(g, made, text, size, writable=False, container=False):
    g.declare(Array(text, size, DOUBLE, *interval(made), True, writable, container=container))
    g.inputs.append(Expression(f"{text}[{size - 1}]", POSTFIX, DOUBLE, *interval(made), True))


def pointers(g, made):
    n, m = g.whole(1, 4), g.whole(1, 3)
    const = g.among("const double *x", "double const *x", f"const double x[{n}]", "double *x")
    made.parameters += [const, g.among("double *y", f"double y[{m}]")]
    made.arguments += ["x", "y"]
    made.objects += [f"double x[{n}];", f"double y[{m}];"]
    made.inputs.append(section("x", n))
    made.outputs.append(section("y", m))
    array(g, made, "x", n)
    return [f"y[{k}]" for k in range(m)]


def scalars(g, made):
    names = [g.local("x") for _ in range(g.whole(1, 3))]
    made.result = "double"
    for name in names:
        made.parameters.append(f"double {name}")
        made.arguments.append(name)
        made.objects.append(f"double {name};")
        made.inputs.append((name, [name]))
        number(g, made, name, False)
    made.outputs.append(("return", ["result"]))
    return []


def in_place(g, made):
    n = g.whole(1, 3)
    made.parameters += ["double *s", "double u"]
    made.arguments += ["s", "u"]
    made.objects += [f"double s[{n}];", "double u;"]
    made.inputs += [section("s", n), ("u", ["u"])]
    made.outputs.append(section("s", n))
    array(g, made, "s", n, True)
    number(g, made, "u")
    return [f"s[{k}]" for k in range(n)]


def structs(g, made):
    given, taken = g.outer("in"), g.outer("out")
    n = g.whole(1, 3)
    g.define(f"struct {given} {{ double a; double v[{n}]; int spare; double b; }};")
    g.define(f"struct {taken} {{ double p; double q; }};")
    made.parameters += [f"const struct {given} *in", f"struct {taken} *out"]
    made.arguments += ["&in", "&out"]
    made.objects += [f"struct {given} in = {{0}};", f"struct {taken} out;"]
    text, elements = section("in->v", n)
    made.inputs += [("in->a", ["in.a"]), (text, [e.replace("->", ".") for e in elements]), ("in->b", ["in.b"])]
    made.outputs += [("out->p", ["out.p"]), ("out->q", ["out.q"])]
    number(g, made, "in->a", binds=15)
    number(g, made, "in->b", binds=15)
    array(g, made, "in->v", n)
    return ["out->p", "out->q"]


def vectors(g, made):
    n, m = g.whole(1, 3), g.whole(1, 2)
    made.parameters += ["const std::vector<double> &x", "std::vector<double> &y"]
    made.arguments += ["x", "y"]
    made.objects += [f"std::vector<double> x({n});", f"std::vector<double> y({m});"]
    made.inputs.append(("x", [f"x[{k}]" for k in range(n)]))
    made.outputs.append(("y", [f"y[{k}]" for k in range(m)]))
    array(g, made, "x", n, container=True)
    return [f"y[{k}]" for k in range(m)]


def arrays(g, made):
    n, m = g.whole(1, 3), g.whole(1, 2)
    made.parameters += [f"const std::array<double, {n}> &x", f"std::array<double, {m}> &y"]
    made.arguments += ["x", "y"]
    made.objects += [f"std::array<double, {n}> x{{}};", f"std::array<double, {m}> y{{}};"]
    made.inputs.append(("x", [f"x[{k}]" for k in range(n)]))
    made.outputs.append(("y", [f"y[{k}]" for k in range(m)]))
    array(g, made, "x", n, container=True)
    return [f"y[{k}]" for k in range(m)]


def references(g, made):
    made.parameters += ["double const &u", "double &v", "double &r"]
    made.arguments += ["u", "v", "r"]
    made.objects += ["double u;", "double v;", "double r;"]
    made.inputs += [("u", ["u"]), ("v", ["v"])]
    made.outputs += [("v", ["v"]), ("r", ["r"])]
    number(g, made, "u")
    number(g, made, "v", writable=True)
    return ["r", "v"]
