"""Variables of a function that keep their value: of constants, which the generated code may compute anew, and of inputs."""
from .arithmetic import DOUBLE, INT
from .expression import ADD
from .generator import Array, Function, Variable, production
from .numbers import tame_number

KEPT = {"SYM214", "SYM053", "SYM017"}


def value(g):
    """A constant within -10 to 10; C initialises with constant expressions alone."""
    plain = g.among("2.5", "-0.75", "1.0/3", "3 * 1.25", "0.1", "-(7.0 - 0.5)")
    if g.language == "c":
        return plain
    return g.among(plain, plain, "std::sqrt(2.0)", "std::cos(0.5) * 3", "std::pow(1.5, 2.0)", "std::fmax(0.1, 1.0/3)", "std::atan2(1.0, 3.0)")


def storage(g):
    """Constant: another number of a function is state, wherever it is changed."""
    thread = "_Thread_local" if g.language == "c" else "thread_local"
    return g.among("static const", "static const", f"static {thread} const")


def scalar(g):
    name = g.local("fix")
    g.line(f"{storage(g)} double {name} = {value(g)};")
    g.declare(Variable(name, DOUBLE, -10.0, 10.0, False, False))


def whole(g):
    name, number = g.local("fix"), g.whole(0, 3)
    g.line(f"{g.among(storage(g), 'static')} int {name} = {number};")
    g.declare(Variable(name, INT, number, number, False, False))


def array(g):
    name, size = g.local("row"), g.whole(2, 4)
    g.line(f"{storage(g)} double {name}[{size}] = {{{', '.join(value(g) for _ in range(size))}}};")
    g.declare(Array(name, size, DOUBLE, -10.0, 10.0, False, False, True))
    if g.chance(0.4) and "hread_local" not in g.body[-1]:  # whose address is no constant
        pointer = g.local("p")
        g.line(f"static double const *const {pointer} = {name if g.language == 'c' else f'&{name}[0]'};")
        g.declare(Array(pointer, size, DOUBLE, -10.0, 10.0, False, False, True))


def matrix(g):
    name = g.local("mat")
    g.line(f"{storage(g)} double {name}[2][2] = {{{{{value(g)}, {value(g)}}}, {{{value(g)}, {value(g)}}}}};")
    for row in range(2):
        g.declare(Array(f"{name}[{row}]", 2, DOUBLE, -10.0, 10.0, False, False, True))


def structure(g):
    name, number = g.local("fix"), g.whole(0, 3)
    g.line(f"static const struct {{ double a; int n; double v[2]; }} {name} = {{{value(g)}, {number}, {{{value(g)}, {value(g)}}}}};")
    g.declare(Variable(f"{name}.a", DOUBLE, -10.0, 10.0, False, False, binds=15))
    g.declare(Variable(f"{name}.n", INT, number, number, False, False, binds=15))
    g.declare(Array(f"{name}.v", 2, DOUBLE, -10.0, 10.0, False, False, True))


def integer_scratch(g):
    """Each path writes it first."""
    name = g.local("count")
    g.line(f"static int {name};")
    g.line(f"{name} = {g.whole(0, 3)};")
    if g.chance(0.5):
        g.line(f"for ({name} = 0; {name} < {g.whole(1, 3)}; {name}++) {{ }}")
    g.declare(Variable(name, INT, 0, 3, False, False))


def container(g):
    name = g.local("list")
    how = g.whole(0, 3)
    if how == 0:
        g.line(f"{storage(g)} std::vector<double> {name}{{{value(g)}, {value(g)}}};")
    elif how == 1:
        g.line(f"static std::vector<double> const {name} = [] {{ std::vector<double> q; for (int i = 0; i < 2; i++) "
               f"q.push_back(std::sin(0.5 + i)); return q; }}();")
    elif how == 2:
        g.line(f"{storage(g)} std::array<double, 2> {name}{{{value(g)}, {value(g)}}};")
    else:
        g.line(f"static std::map<int, double> const {name}{{{{0, {value(g)}}}, {{1, {value(g)}}}}};")
        for key in range(2):
            g.declare(Variable(f"{name}.at({key})", DOUBLE, -10.0, 10.0, False, False))
        return
    g.declare(Array(name, 2, DOUBLE, -10.0, 10.0, False, False, True, True))


def owner(g):
    name = g.local("own")
    g.line(g.among(f"static std::unique_ptr<double> const {name}(new double({value(g)}));",
                   f"static auto const {name} = std::make_shared<double>({value(g)});",
                   f"static std::unique_ptr<double> const {name} = std::make_unique<double>({value(g)});",
                   f"static double const *const {name} = new double({value(g)});",
                   f"thread_local std::unique_ptr<double> const {name}(new double({value(g)}));"))
    g.declare(Variable(f"*{name}", DOUBLE, -10.0, 10.0, False, False, binds=14))


def reference(g):
    name = g.local("ref")
    g.line(g.among(f"static double const &{name} = {value(g)};", f"static std::vector<double> const &{name}_list = std::vector<double>{{{value(g)}, 1}};\n"
                   f"static double const &{name} = {name}_list[0];"))
    g.declare(Variable(name, DOUBLE, -10.0, 10.0, False, False))


def callable_object(g):
    name = g.local("law")
    body = g.among("z * 0.5", "z + 1", "1 - z", "std::cos(z)")
    g.line(g.among(f"static std::function<double(double)> const {name} = [](double z) {{ return {body}; }};",
                   f"static auto const {name} = [](double z) {{ return {body}; }};",
                   f"static auto const {name} = [k = {g.among('2.5', '-0.75', '1.0/3')}](double z) {{ return {body} + k; }};"))
    g.declare(Function(name, [(DOUBLE, -50.0, 50.0)], DOUBLE, -70.0, 70.0, True))


def text(g):
    name = g.local("word")
    word = g.among("on", "off", "auto")
    if g.language == "c":
        g.line(f'static const char *const {name} = "{word}";')
        g.declare(Variable(f"(int)strlen({name})", INT, 2, 4, False, False, binds=14))
    else:
        g.line(f'static std::string const {name} = "{word}";')
        g.declare(Variable(f"(int){name}.size()", INT, 2, 4, False, False, binds=14))


OF_CONSTANTS = [scalar, scalar, whole, array, matrix, structure, integer_scratch, text]
OF_CONSTANTS_CXX = [container, container, owner, reference, callable_object]


@production("statement", 4, "statics")
def of_constants(g, depth):
    g.random.choice(OF_CONSTANTS + (OF_CONSTANTS_CXX if g.language == "cxx" else []))(g)
    return True


def declare_statics(g, made):
    """One of a member of the program that `constant` names; and one of inputs, which is surely met."""
    if g.has("statics") and g.language == "cxx" and g.chance(0.3):
        gain, name = g.outer("gain"), g.local("fix")
        g.define(f"static double {gain} = {g.among('1.25', '-2.0', '0.3')};\nvoid {gain}_set(double value) {{ {gain} = value; }}")
        made.clauses.append(f"constant({gain})")
        g.line(g.among(f"static double const {name} = {gain} * 2;", f"static double const &{name} = {gain};",
                       f"static std::array<double, 1> const {name}_list{{{gain}}};\ndouble const {name} = {name}_list[0];"))
        g.declare(Variable(name, DOUBLE, -10.0, 10.0, False, False))
    if g.has("statics_of_inputs") and g.chance(0.7):
        of_input = f"{g.random.choice(g.inputs).at(ADD)} + {tame_number(g, 1, 4).at(ADD)}"
        read = g.random.choice(OF_INPUTS_C if g.language == "c" else OF_INPUTS_CXX)(g, g.local("first"), of_input)
        kept = g.local("kept")
        g.line(f"double {kept} = {read};")
        g.shown.append(kept)
        g.expected |= KEPT


def lazily(g, name, of_input):
    g.line(f"static double {name}; static int {name}_set;")
    g.line(f"if (!{name}_set) {{ {name} = {of_input}; {name}_set = 1; }}")
    return name


def lazy_table(g, name, of_input):
    g.line(f"static double {name}[2]; static int {name}_set;")
    g.line(f"if ({name}_set == 0) {{ {name}[0] = {of_input}; {name}[1] = 2 * {name}[0]; {name}_set++; }}")
    return f"{name}[1]"


def lazy_constants(g, name, of_input):
    g.line(f"static double {name}[2]; static int {name}_set;")
    g.line(f"if (!{name}_set) {{ {name}[0] = 0.5; {name}[1] = 2.5; {name}_set = 1; }}")
    return f"{name}[1]"


def never_changed(g, name, of_input):
    g.line(f"static double {name}{g.among('', '[2]')} = {{2.5}};")
    return f"{name}[0]" if "[2]" in g.body[-1] else name


def last_value(g, name, of_input):
    g.line(f"static double {name} = 0.5;")
    g.line(f"double {name}_was = {name};")
    g.line(f"{name} = {of_input};")
    return f"{name}_was"


def of_thread(g, name, of_input):
    thread = "_Thread_local" if g.language == "c" else "thread_local"
    g.line(f"static {thread} double {name};")
    g.line(f"if ({name} == 0) {name} = 2.5; else {name} = 0.5 * {name};")
    return name


def declared(text, read):
    """A static variable whose initialiser has the input."""
    def make(g, name, of_input):
        g.line(text.replace("NAME", name).replace("INPUT", of_input))
        return read.replace("NAME", name)
    return make


OF_INPUTS_C = [lazily, lazy_table, lazy_constants, never_changed, last_value, of_thread]
OF_INPUTS_CXX = [lazily, lazy_table, never_changed, last_value, of_thread] + [declared(*pair) for pair in (
    ("static double const NAME = INPUT;", "NAME"),
    ("static double NAME = INPUT;", "NAME"),
    ("thread_local double const NAME = INPUT;", "NAME"),
    ("static thread_local double NAME = INPUT;", "NAME"),
    ("static double const NAME[2] = {INPUT, 1};", "NAME[0]"),
    ("static struct { double a, b; } const NAME = {1, INPUT};", "NAME.b"),
    ("static std::vector<double> const NAME{1, INPUT};", "NAME[1]"),
    ("static std::vector<double> const NAME(3, INPUT);", "NAME[2]"),
    ("static std::array<double, 2> const NAME{INPUT, 2};", "NAME[0]"),
    ("static std::map<int, double> const NAME{{1, INPUT}};", "NAME.at(1)"),
    ("static std::pair<int, double> const NAME(1, INPUT);", "NAME.second"),
    ("static std::tuple<double, int> const NAME(INPUT, 2);", "std::get<0>(NAME)"),
    ("static std::optional<double> const NAME = INPUT;", "*NAME"),
    ("static std::complex<double> const NAME(1, INPUT);", "NAME.imag()"),
    ("static std::unique_ptr<double> const NAME(new double(INPUT));", "*NAME"),
    ("static std::shared_ptr<double> const NAME = std::make_shared<double>(INPUT);", "*NAME"),
    ("static double const *const NAME = new double(INPUT);", "*NAME"),
    ("static double const &NAME = INPUT;", "NAME"),
    ("static auto const NAME = [k = INPUT](double z) { return z + k; };", "NAME(1)"),
    ("static std::function<double(double)> const NAME = [k = INPUT](double z) { return z * k; };", "NAME(2)"),
    ("static std::vector<std::vector<double>> const NAME = [&] { return std::vector<std::vector<double>>{{1}, {INPUT}}; }();", "NAME[1][0]"),
)]
