"""Templates, overloads and lambdas of C++."""
from .arithmetic import DOUBLE, INT, Integer
from .expression import POSTFIX, number, Expression
from .generator import Block, Function, Variable, production
from .integers import bounded, integer
from .numbers import constant, some_number, tame_number

WIDE = (-50.0, 50.0)


def small(g, depth):
    """An argument of one type or the other."""
    if g.has("integers") and g.chance(0.4):
        return bounded(g, integer(g, depth), -50, 50)
    return tame_number(g, depth, 50)


@production("definition", 4, "templates", "cxx")
def template(g, depth):
    g.random.choice([generic, sized, asking, variadic, of_class])(g)
    return True


def generic(g):
    """The type is deduced; for integers it is integer arithmetic."""
    name = g.outer("mix")
    body = g.among(f"a * T({g.whole(2, 4)}) + b", "a < b ? b - a : a - b" if g.decides else "b - a - b", f"a / T({g.among(2, 3, 4)}) - b", "a - b * b",
                   "static_cast<T>(a + b) * T(2)")
    g.define(f"template <class T> static T {name}(T a, T b) {{ return {body}; }}")
    g.functions.append(Function(name, [(DOUBLE, *WIDE), (DOUBLE, *WIDE)], DOUBLE, -3000.0, 3000.0, deduced=True))
    if g.has("integers"):
        g.functions.append(Function(f"{name}<int>", [(INT, -50, 50), (INT, -50, 50)], INT, -3000, 3000))
        g.functions.append(Function(f"{name}<double>", [(INT, -50, 50), (DOUBLE, *WIDE)], DOUBLE, -3000.0, 3000.0))


def sized(g):
    name, count = g.outer("power"), g.whole(1, 3)
    g.define(f"template <int N> static double {name}(double z) {{ double p = 1; for (int i = 0; i < N; i++) p *= z; return p; }}")
    g.functions.append(Function(f"{name}<{count}>", [(DOUBLE, *WIDE)], DOUBLE, -1.3e5, 1.3e5))


def asking(g):
    """What it does depends on the type."""
    name = g.outer("kind")
    g.define(g.among(
        f"template <class T> static double {name}(T z) {{ if constexpr (std::is_integral_v<T>) return z / 2; else return z / 2 + 0.25; }}",
        f"template <class T> static double {name}(T z) {{ return std::is_floating_point<T>::value ? z * 1.5 : z + 1; }}",
        f"template <class T> static std::enable_if_t<std::is_floating_point_v<T>, double> {name}(T z) {{ return z - 1; }}\n"
        f"template <class T> static std::enable_if_t<std::is_integral_v<T>, double> {name}(T z) {{ return z % 3; }}",
        f"static double {name}_of(int z) {{ return z * 2; }}\nstatic double {name}_of(double z) {{ return z * 0.5; }}\n"
        f"template <class T> static double {name}(T z) {{ return {name}_of(z) + 1; }}"))
    g.functions.append(Function(name, [(DOUBLE, *WIDE)], DOUBLE, -200.0, 200.0, deduced=True))
    if g.has("integers"):
        g.functions.append(Function(f"{name}<int>", [(INT, -50, 50)], DOUBLE, -200.0, 200.0))


def variadic(g):
    name = g.outer("sum")
    g.define(f"template <class... T> static double {name}(T... z) {{ return ({g.among('z + ...', '... + z', '0.5 + ... + z')}); }}")

    def use(g, depth):
        values = [small(g, depth - 1) for _ in range(g.whole(1, 3))]
        return number(f"{name}({', '.join(v.text for v in values)})", POSTFIX, (-200, 200), any(v.symbolic for v in values))
    g.idioms.append(use)


def of_class(g):
    name, count = g.outer("Row"), g.whole(2, 3)
    g.define(f"template <class T, int N> struct {name} {{\n  T v[N];\n  T dot({name} const &o) const {{ T s = 0; for (int i = 0; i < N; i++) "
             f"s += v[i] * o.v[i]; return s; }}\n  T &operator[](int i) {{ return v[i]; }}\n}};")

    def use(g, depth):
        a, b = g.local("row"), g.local("row")
        values = [[tame_number(g, 1, 50) for _ in range(count)] for _ in range(2)]
        for made, elements in zip((a, b), values):
            g.line(f"{name}<double, {count}> {made}{{{{{', '.join(e.text for e in elements)}}}}};")
        g.line(f"{a}[{g.whole(0, count - 1)}] {g.among('=', '-=')} {tame_number(g, 1, 50).text};")
        g.declare(Variable(f"{a}.dot({b})", DOUBLE, -1e5, 1e5, True, False))
        return True
    g.statements_of_idioms.append(use)


@production("definition", 3, "overloads", "cxx")
def overloaded(g, depth):
    name = g.outer("law")
    kinds = [k for k in ("int", "double", "long", "bool", "char", "unsigned") if g.chance(0.5)]
    if "double" not in kinds:
        kinds.append("double")
    if g.chance(0.3):
        g.define(f"struct {name}_v {{ double d; {name}_v(double z) : d(z) {{}} }};\n"
                 f"static double {name}({name}_v const &z) {{ return z.d * 3 - 1; }}")
    for k, kind in enumerate(kinds):
        g.define(f"static double {name}({kind} z) {{ return z * {g.among('2.0', '0.5', '3')} + {k}; }}")
    if "int" in kinds and g.chance(0.3):
        g.define(f"template <class T> static double {name}_t(T z) {{ return {name}(z) - 1; }}")
        g.functions.append(Function(f"{name}_t", [(DOUBLE, *WIDE)], DOUBLE, -200.0, 200.0, deduced=True))

    def use(g, depth):
        if "int" in kinds and g.has("integers") and g.chance(0.5):
            made = bounded(g, integer(g, depth - 1), -50, 50)
            spelled = {"int": INT}["int"]
            text = made.text if made.type == spelled else f"static_cast<int>({made.text})"
            return number(f"{name}({text})", POSTFIX, (-200, 200), made.symbolic)
        if "bool" in kinds and g.has("truth_values") and g.chance(0.3):
            from .conditions import condition
            made = condition(g, depth - 1)
            return number(f"{name}({made.text})", POSTFIX, (-200, 200), made.symbolic)
        if "char" in kinds and g.chance(0.2):
            return number(f"{name}('b')", POSTFIX, (-300, 300), False)
        made = tame_number(g, depth - 1, 50)
        return number(f"{name}({made.text})", POSTFIX, (-200, 200), made.symbolic)
    g.idioms.append(use)
    return True


@production("statement", 4, "lambdas", "cxx")
def local_function(g, depth):
    name = g.local("fn")
    if g.chance(0.4):
        body = g.among("p + q * 2", "p < q ? q : p" if g.decides else "p * 0.5 - q", "p - q", "p * q + p")
        g.line(f"auto {name} = [](auto p, auto q) {{ return {body}; }};")

        def use(g, depth):
            a, b = small(g, depth - 1), small(g, depth - 1)
            # Two integers of other types than int would compute in theirs.
            if not a.is_number and not b.is_number:
                b = tame_number(g, depth - 1, 50)
            return number(f"{name}({a.text}, {b.text})", POSTFIX, (-3000, 3000), a.symbolic or b.symbolic)
        made = g.declare(Idiom(use))
        return bool(made)
    capture = g.among("[&]", "[=]", "[&]")
    z = g.local("z")
    g.scopes.append([])
    g.declare(Variable(z, DOUBLE, *WIDE, True, False))
    body = tame_number(g, 2, 1000)
    g.scopes.pop()
    result = g.among("", "", " -> double")
    if body.type != DOUBLE:
        result = " -> double"
    g.line(f"auto {name} = {capture}(double {z}){result} {{ return {body.text}; }};")
    # What it captures may change, but stays within what a call gives by its interval.
    g.declare(Function(name, [(DOUBLE, *WIDE)], DOUBLE, body.low, body.high, True))
    return True


class Idiom:
    """Something in scope that makes a number in a way of its own."""

    def __init__(self, use):
        self.use = use


@production("number", 4, None, "cxx")
def idiom(g, depth):
    usable = g.idioms + [t.use for t in g.visible() if isinstance(t, Idiom)]
    return g.random.choice(usable)(g, depth) if usable else None


@production("statement", 4, None, "cxx")
def statement_of_idiom(g, depth):
    return g.random.choice(g.statements_of_idioms)(g, depth) if g.statements_of_idioms else None


@production("statement", 3, "order", "cxx")
def two_calls(g, depth):
    """Both change what they read; the language leaves open which comes first."""
    name, state, made = g.local("nx"), g.local("st"), g.local("r")
    g.line(f"int {state} = {g.whole(1, 5)};")
    g.line(f"auto {name} = [&] {{ return {state} = {state} * 3 + 1; }};")
    g.line(f"double {made} = {name}() - 2 * {name}() + {tame_number(g, 1, 100).text};")
    g.declare(Variable(made, DOUBLE, -1000.0, 1000.0, True))
    return True
