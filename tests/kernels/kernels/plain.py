"""Arguments that are no numbers of the kernel: modes, lengths, depths, members, text. Generated code has those of the recording;
a wrapper compares them."""
from dataclasses import dataclass

from .arithmetic import BOOL, DOUBLE, INT, UNSIGNED, Integer
from .generator import Array, Variable
from .numbers import tame_number


@dataclass
class Plain:
    element: str   # of the caller
    values: list   # the first is the recorded one


def argument(g, made, declaration, name, values, clause=True):
    made.parameters.append(declaration)
    made.arguments.append(name)
    made.objects.append(f"{declaration} = {values[0]};")
    made.plains.append(Plain(name, values))
    if clause:
        made.clauses.append(f"constant({name})")


def drawn(g, values):
    return g.random.sample(values, len(values))


def mode(g, made):
    name = g.local("mode")
    spelling, type = g.among(("int", INT), ("int", INT), ("short", Integer(16, True)), ("unsigned", UNSIGNED), ("unsigned char", Integer(8, False)),
                             ("long", Integer(64, True)))
    argument(g, made, f"{spelling} {name}", name, drawn(g, ["0", "1", "2", "3"]))
    g.declare(Variable(name, type, 0, 3, False, False))


def enumerator(g, made):
    kind, name = g.outer("kind"), g.local("kind")
    names = [f"{kind.upper()}_{stem}" for stem in ("SLOW", "FAST", "AUTO")]
    g.define(f"enum {kind} {{ {names[0]}, {names[1]} = 3, {names[2]} }};")
    argument(g, made, f"enum {kind} {name}", name, drawn(g, names))
    g.declare(Variable(name, UNSIGNED if g.language == "c" else INT, 0, 4, False, False))


def flag(g, made):
    name = g.local("on")
    argument(g, made, f"{'_Bool' if g.language == 'c' else 'bool'} {name}", name, drawn(g, ["0", "1"] if g.language == "c" else ["false", "true"]))
    g.declare(Variable(name, BOOL, 0, 1, False, False))


def gain(g, made):
    name = g.local("gain")
    argument(g, made, f"double {name}", name, drawn(g, ["1.25", "-2.0", "0.0", "3.5"]))
    g.declare(Variable(name, DOUBLE, -2.0, 3.5, False, False))


def members(g, made):
    """A structure of what is fixed: by value, by pointer, by reference."""
    type, name = g.outer("conf"), g.local("conf")
    bits = g.chance(0.3)
    g.define(f"struct {type} {{ int count; short kind; {'unsigned level : 3;' if bits else 'unsigned char level;'} double ratio; int unused; }};")
    how = g.among("value", "pointer", "pointer", "reference" if g.language == "cxx" else "value")
    made.objects.append(f"struct {type} {name} = {{2, 1, 3, 0.75, 5}};")
    star = {"value": "", "pointer": "*", "reference": "&"}[how]
    made.parameters.append(f"{'' if how == 'value' else 'const '}struct {type} {star}{name}")
    made.arguments.append(f"&{name}" if how == "pointer" else name)
    made.clauses.append(f"constant({'*' if how == 'pointer' else ''}{name})")
    made.plains += [Plain(f"{name}.count", ["2", "1", "3", "0"]), Plain(f"{name}.kind", ["1", "0", "2"]), Plain(f"{name}.level", ["3", "1", "7"]),
                    Plain(f"{name}.ratio", ["0.75", "-1.5", "0.0"]), Plain(f"{name}.unused", ["5", "6"])]
    prefix = name + ("->" if how == "pointer" else ".")
    for member, kind, low, high in (("count", INT, 0, 3), ("kind", Integer(16, True), 0, 2), ("level", INT if bits else Integer(8, False), 0, 7),
                                    ("ratio", DOUBLE, -1.5, 0.75)):
        if g.chance(0.7):
            g.declare(Variable(prefix + member, kind, low, high, False, False, binds=15))


def length(g, made):
    """An array whose length is an argument: the kernel reads as many elements as there are."""
    name, count, size = g.local("v"), g.local("n"), g.whole(2, 4)
    made.parameters += [f"const double *{name}", f"int {count}"]
    made.arguments += [name, count]
    made.objects += [f"double {name}[{size}];", f"int {count} = {size};"]
    made.inputs.append((f"{name}[0:{count}]", [f"{name}[{k}]" for k in range(size)]))
    made.plains.append(Plain(count, [str(size), str(size - 1), "1"]))
    total = g.local("total")
    g.line(f"double {total} = 0;")
    g.line(f"for (int at = 0; at < {count}; at++) {total} += {name}[at]{g.among('', ' * 0.5', f' * {name}[0]')};")
    g.declare(Variable(total, DOUBLE, None, None, True, False))
    g.declare(Variable(count, INT, 1, size, False, False))
    g.declare(Array(name, 1, DOUBLE, *((made.low, made.high) if made.tame else (None, None)), True, False))


def depth(g, made):
    name, function, made_of = g.local("depth"), g.outer("again"), g.local("deep")
    body = g.among(f"{function}(0.5 * z + depth, depth - 1)", f"0.5 * {function}(z, depth - 1) + depth", f"{function}(z, depth - 1) - 0.25 * z")
    g.define(f"static double {function}(double z, int depth) {{ return depth > 0 ? {body} : z; }}")
    argument(g, made, f"int {name}", name, drawn(g, ["0", "1", "2", "4"]))
    g.line(f"double {made_of} = {function}({tame_number(g, 1, 50).text}, {name});")
    g.declare(Variable(made_of, DOUBLE, -200.0, 200.0, True, False))


def word(g, made):
    name, same = g.local("word"), g.local("is")
    argument(g, made, f"const char *{name}", name, drawn(g, ['"on"', '"off"', '""']), False)
    g.line(f'int {same} = strcmp({name}, "on") == 0;')
    g.declare(Variable(same, INT, 0, 1, False, False))


def integers_of_library(g, made):
    """Integers that functions of the library read, by pointers and references."""
    name = g.local("w")
    made.parameters.append(f"const int *{name}")
    made.arguments.append(name)
    made.objects.append(f"int {name}[3] = {{5, 3, 4}};")
    made.clauses.append(f"constant({name}[0:3])")
    made.plains += [Plain(f"{name}[{k}]", values) for k, values in enumerate((["5", "6"], ["3", "0", "7"], ["4", "8"]))]
    g.declare(Variable(read_by_library(g, name), INT, 0, 30, False, False, binds=14))


def read_by_library(g, name):
    """An expression of an integer that a function of the library has read of three."""
    copy = g.local("copy")
    how = g.whole(0, 5 if g.language == "cxx" else 1)
    if how == 0:
        g.line(f"int {copy}[3];")
        g.line(f"{g.among('memcpy', 'memmove')}({copy}, {name}, sizeof {copy});")
    elif how == 1:
        kept = g.outer("three")
        g.define(f"struct {kept} {{ int v[3]; }};")
        g.line(f"struct {kept} {copy}_of;")
        g.line(f"memcpy(&{copy}_of, {name}, sizeof {copy}_of);")
        return f"{copy}_of.v[{g.whole(0, 2)}]"
    elif how == 2:
        g.line(f"int {copy}[3];")
        g.line(f"std::copy({name}, {name} + 3, {copy});")
    elif how == 3:
        g.line(f"std::vector<int> const {copy}({name}, {name} + 3);")
    else:
        return g.among(f"std::max({name}[1], 2)", f"std::accumulate({name}, {name} + 3, 1)", f"(int)std::count({name}, {name} + 3, 4)",
                       f"*std::max_element({name}, {name} + 3)")
    return f"{copy}[{g.whole(0, 2)}]"


TABLES = [["0.5", "1.25", "-2.0"], ["0.5", "3.0", "-2.0"], ["-1.75", "0.0", "2.5"]]


def tables(g):
    """Constants that a caller chooses among."""
    names = [g.outer("table") for _ in TABLES]
    for name, numbers in zip(names, TABLES):
        g.define(f"static double const {name}[3] = {{{', '.join(numbers)}}};")
    return names


def table(g, made):
    """Handed over by a pointer, or by a structure that leads there."""
    name, first = g.local("table"), tables(g)
    how = g.among("pointer", "pointer", "structure", "value")
    if how == "pointer":
        read = name
        argument(g, made, f"double const *{name}", name, first, False)
        made.clauses.append(f"constant({name}[0:3])")
    else:
        type, is_value = g.outer("leads"), how == "value"  # where a whole argument counts as read
        g.define(f"struct {type} {{ {'' if is_value else 'int unused; '}double const *at; }};")
        made.objects.append(f"struct {type} {name} = {{{'' if is_value else '1, '}{first[0]}}};")
        made.parameters.append(f"struct {type} {name}" if is_value else f"const struct {type} *{name}")
        made.arguments.append(name if is_value else f"&{name}")
        read = f"{name}.at" if is_value else f"{name}->at"
        made.clauses.append(f"constant({read}, {read}[0:3])")
        made.plains.append(Plain(f"{name}.at", first))
    g.declare(Array(read, 3, DOUBLE, -2.0, 3.0, False, False))


KINDS = [mode, mode, enumerator, flag, gain, members, length, depth, word, integers_of_library, table, table]


def declare_plain(g, made):
    if g.has("plain_arguments"):
        for kind in g.random.sample(KINDS, g.whole(1, 2)):
            kind(g, made)
