"""Classes of C++: operators, members, inheritance, references."""
from .arithmetic import DOUBLE, INT
from .expression import POSTFIX, number
from .generator import Array, Function, Variable, is_double, production
from .numbers import constant, some_number, tame_number

OPERATORS = """struct {0} {{
  double x, y;
  {0} operator+({0} const &o) const {{ return {{x + o.x, y + o.y}}; }}
  {0} operator-() const {{ return {{-x, -y}}; }}
  {0} &operator*=(double f) {{ x *= f; y *= f; return *this; }}
  friend {0} operator*(double f, {0} a) {{ return a *= f; }}
  friend double operator*({0} const &a, {0} const &b) {{ return a.x * b.x + a.y * b.y; }}
  double operator[](int i) const {{ return i == 0 ? x : y; }}
}};"""


@production("definition", 3, "operators", "cxx")
def vector_class(g, depth):
    name = g.outer("V")
    g.define(OPERATORS.format(name))

    def use(g, depth):
        a, b = g.local("va"), g.local("vb")
        values = [tame_number(g, 1, 30).text for _ in range(4)]
        g.line(g.among(f"{name} {a}{{{values[0]}, {values[1]}}};", f"auto {a} = {name}{{{values[0]}, {values[1]}}};"))
        step = g.among(f"{a} + 2.0 * {a}", f"-{a}", f"3 * {a}", f"{a} + {name}{{{values[2]}, {values[3]}}}", f"0.5 * (-{a} + {a})")
        g.line(f"{name} {b} = {step};")
        if g.chance(0.4):
            g.line(f"{b} *= {g.among('2', '0.5', '-1')};")
        if g.chance(0.3):
            g.line(f"{a} = {b};")
        g.declare(Variable(g.among(f"({a} * {b})", f"({b} * {b})", f"({a} * ({a} + {b}))"), DOUBLE, -1e6, 1e6, True, False))
        g.declare(Variable(f"{b}[{g.whole(0, 1)}]", DOUBLE, -1000.0, 1000.0, True, False))
        g.declare(Variable(f"{a}.x", DOUBLE, -200.0, 200.0, True, False))
        return True
    g.statements_of_idioms.append(use)
    return True


@production("definition", 3, "classes", "cxx")
def a_class(g, depth):
    g.random.choice([with_members, with_bases, functor])(g)
    return True


def with_members(g):
    name = g.outer("Joint")
    g.define(f"class {name} {{\n  double gain, offset = {constant(g).text};\n  int order;\n"
             f"public:\n  explicit {name}(double g, int n = {g.whole(1, 3)}) : gain(g), order(n) {{}}\n"
             f"  double at(double z) const {{ double s = offset; for (int i = 0; i < order; i++) s = s * {g.among('0.5', '0.25')} + gain * z; return s; }}\n"
             f"  void raise(double by) {{ gain += by; }}\n  int size() const {{ return order; }}\n"
             f"  static double unit() {{ return {constant(g).text}; }}\n}};")

    def use(g, depth):
        made = g.local("joint")
        g.line(f"auto {made} = {name}({tame_number(g, 1, 10).text}{g.among('', ', 2', ', 1')});")
        if g.chance(0.5):
            g.line(f"{made}.raise({tame_number(g, 1, 10).text});")
        g.declare(Function(f"{made}.at", [(DOUBLE, -10.0, 10.0)], DOUBLE, -5000.0, 5000.0, True))
        g.declare(Variable(f"{made}.size()", INT, 1, 3, False, False))
        return True
    g.statements_of_idioms.append(use)
    g.idioms.append(lambda g, depth: number(f"{name}::unit()", POSTFIX, (-10, 10), False))


def with_bases(g):
    base, first, second = g.outer("Law"), g.outer("Spring"), g.outer("Damper")
    g.define(f"struct {base} {{\n  virtual ~{base}() = default;\n  virtual double force(double z) const {{ return z; }}\n}};\n"
             f"struct {first} : {base} {{\n  double k;\n  explicit {first}(double k) : k(k) {{}}\n"
             f"  double force(double z) const override {{ return -k * z; }}\n}};\n"
             f"struct {second} final : {first} {{\n  using {first}::{first};\n"
             f"  double force(double z) const override {{ return {first}::force(z) + {base}::force(z) * z; }}\n}};")

    def use(g, depth):
        made, reference = g.local("law"), g.local("any")
        kind = g.among(first, second)
        g.line(f"{kind} {made} = {kind}({tame_number(g, 1, 10).text});")
        g.line(f"{base} const &{reference} = {made};")
        g.declare(Function(f"{reference}.force", [(DOUBLE, -10.0, 10.0)], DOUBLE, -500.0, 500.0, True))
        return True
    g.statements_of_idioms.append(use)


def functor(g):
    name = g.outer("Line")
    g.define(f"struct {name} {{\n  double m = {constant(g).text}, c = 0;\n  double operator()(double z) const {{ return m * z + c; }}\n"
             f"  double operator()(double z, int n) const {{ return n > 1 ? m * z : c; }}\n}};")

    def use(g, depth):
        made = g.local("line")
        g.line(f"{name} {made};")
        g.line(f"{made}.c = {tame_number(g, 1, 50).text};")
        g.declare(Function(made, [(DOUBLE, -50.0, 50.0)], DOUBLE, -1000.0, 1000.0, True))
        return True
    g.statements_of_idioms.append(use)


@production("statement", 3, "references", "cxx")
def reference(g, depth):
    things = g.variables(is_double, writable=True) + g.arrays(is_double, writable=True)
    if not things:
        return None
    thing = g.random.choice(things)
    name = g.local("ref")
    text = thing.text if isinstance(thing, Variable) else f"{thing.text}[{g.whole(0, thing.size - 1)}]"
    g.line(f"{g.among('double', 'auto')} &{name} = {text};")
    g.declare(Variable(name, DOUBLE, thing.low, thing.high, True))
    return True
