"""Tables, structs, enumerations, bit-fields."""
from .arithmetic import DOUBLE, INT, LONG, UNSIGNED, Integer
from .generator import Array, Function, Variable, is_double, production
from .integers import bounded, integer
from .numbers import CONSTANTS, some_number, tame_number
from .statements import fitting, fitting_number, integer_type, spelled


@production("definition", 3, "tables")
def table(g, depth):
    name, size = g.outer("table"), g.whole(3, 8)
    if g.has("integers") and g.chance(0.3):
        values = [g.whole(-9, 9) for _ in range(size)]
        g.define(f"static const int {name}[{size}] = {{{', '.join(map(str, values))}}};")
        g.scopes[0].append(Array(name, size, INT, -9, 9, False, False, True))
        return True
    values = [g.random.choice(["0.5", "2.0", "-1.5", "3.25", "0.1", "-7.0", "4", "0.0"]) for _ in range(size)]
    const = "" if g.has("undeclared_state") and g.chance(0.5) else "const "
    g.define(f"static {const}double {name}[{size}] = {{{', '.join(values)}}};")
    g.scopes[0].append(Array(name, size, DOUBLE, -7.0, 4.0, False, False, True))
    return True


@production("definition", 2, "enumerations")
def enumeration(g, depth):
    name = g.outer("mode")
    negative = g.chance(0.3)
    names = [f"{name.upper()}_{stem}" for stem in ("OFF", "ON", "AUTO")]
    first = f"{names[0]} = -1" if negative else names[0]
    g.define(f"enum {name} {{ {first}, {names[1]}{' = 5' if g.chance(0.3) else ''}, {names[2]} }};")
    values = [-1, 0, 1] if negative else [0, 1, 2]
    if " = 5" in g.definitions[-1]:
        values[1:] = [5, 6]
    for text, value in zip(names, values):
        g.scopes[0].append(Variable(text, INT, value, value, False, False))
    # C's enumerations are of type unsigned in gcc unless a value is negative; C++ promotes to int.
    type = UNSIGNED if g.language == "c" and not negative else INT
    g.enumerations.append((name, names, type, values[0], values[2]))
    return True


@production("statement", 3, "enumerations")
def enumerator(g, depth):
    if not g.enumerations:
        return None
    name, names, type, low, high = g.random.choice(g.enumerations)
    made = g.local("mode")
    g.line(f"enum {name} {made} = {g.random.choice(names)};")
    g.declare(Variable(made, type, low, high, False, False))
    return True


@production("definition", 3, "structs")
def struct(g, depth):
    """Numbers, integers and bit-fields; `fields` are (name, type, low, high, declaration)."""
    name, fields = g.outer("part"), []
    for k in range(g.whole(2, 4)):
        field = f"{g.among('a', 'b', 'm', 'g')}{k}"
        draw = g.random.random()
        if draw < 0.5 or not g.has("integers"):
            fields.append((field, DOUBLE, -100.0, 100.0, f"double {field};"))
        elif draw < 0.75 or not g.has("bit_fields"):
            type = integer_type(g)
            low, high = (-1000, 1000) if type.signed and type.bits >= 32 else (type.low, type.high)
            fields.append((field, type, low, high, f"{spelled(g, type)} {field};"))
        else:
            fields.append(bit_field(g, field))
    if not any(f[1] == DOUBLE for f in fields):
        fields.append(("d", DOUBLE, -100.0, 100.0, "double d;"))
    g.define(f"struct {name} {{ {' '.join(f[4] for f in fields)} }};")
    g.structs.append((name, fields))
    if g.has("helpers") and g.chance(0.6):
        reader(g, name, fields)
    return True


def bit_field(g, field):
    if g.has("wide_bit_fields") and g.chance(0.4):
        bits = g.whole(33, 48)
        # C++ promotes to the declared type; gcc's C computes with as many bits as there are.
        type = Integer(64, False) if g.language == "cxx" else Integer(bits, False)
        return field, type, 0, (1 << bits) - 1, f"unsigned long long {field} : {bits};"
    bits = g.whole(1, 9)
    if g.chance(0.5) and bits > 1:
        return field, INT, -(1 << (bits - 1)), (1 << (bits - 1)) - 1, f"signed int {field} : {bits};"
    return field, INT, 0, (1 << bits) - 1, f"unsigned {field} : {bits};"


def reader(g, struct_name, fields):
    """A function that is given the struct, by value or by pointer."""
    from .statements import statements
    from .generator import Block
    name = g.outer("of")
    by_value = g.chance(0.4)
    with g.function_scope() as body:
        for field, type, low, high, _ in fields:
            g.declare(Variable(f"q.{field}" if by_value else f"q->{field}", type, low, high, True, by_value, binds=15))
        outer_result = g.result
        g.result = lambda g: tame_number(g, 2, 1000)
        statements(g, g.whole(0, 2), 1)
        g.line(f"return {g.result(g).text};")
        g.result = outer_result
    parameter = f"struct {struct_name} q" if by_value else f"const struct {struct_name} *q"
    g.definitions.append(Block(f"static double {name}({parameter}) {{", list(body)))
    g.readers.append((name, struct_name, by_value))


@production("statement", 5, "structs")
def declare_struct(g, depth):
    if not g.structs:
        return None
    struct_name, fields = g.random.choice(g.structs)
    name = g.local("o")
    values = []
    for field, type, low, high, _ in fields:
        if type == DOUBLE:
            made = fitting_number(g, 2, low, high)
        else:
            made = bounded(g, integer(g, 1), max(low, -100), min(high, 100)) if low < 0 else \
                bounded(g, integer(g, 1), 0, min(high, 2 ** 40 - 1))
        values.append((field, made))
    braces = g.language == "c" or all(f[1] == DOUBLE for f in fields)  # C++ converts no integer within braces
    if braces and g.chance(0.4):
        g.line(f"struct {struct_name} {name} = {{{', '.join(m.text for _, m in values)}}};")
    elif braces and g.chance(0.3):
        g.line(f"struct {struct_name} {name} = {{{', '.join(f'.{f} = {m.text}' for f, m in values)}}};")
    else:
        g.line(f"struct {struct_name} {name};")
        for field, made in values:
            g.line(f"{name}.{field} = {made.text};")
    prefix = f"{name}."
    if g.has("pointers") and g.chance(0.3):
        pointer = g.local("r")
        g.line(f"struct {struct_name} *{pointer} = &{name};")
        prefix = f"{pointer}->"
    for field, type, low, high, declaration in fields:
        if type != DOUBLE and type.signed and type.bits >= 32:
            low, high = max(low, -1000), min(high, 1000)
        g.declare(Variable(prefix + field, type, low, high, True, True, binds=15))
    g.declare(StructObject(name, struct_name))
    return True


class StructObject:
    def __init__(self, text, struct_name):
        self.text, self.struct_name = text, struct_name


@production("statement", 3, "structs")
def copy_struct(g, depth):
    objects = [t for t in g.visible() if isinstance(t, StructObject)]
    pairs = [(a, b) for a in objects for b in objects if a is not b and a.struct_name == b.struct_name]
    if not pairs:
        return None
    a, b = g.random.choice(pairs)
    g.line(f"{a.text} = {b.text};")
    return True


@production("statement", 4, "structs")
def read_struct(g, depth):
    objects = [t for t in g.visible() if isinstance(t, StructObject)]
    usable = [(o, r) for o in objects for r in g.readers if r[1] == o.struct_name]
    if not usable or g.in_helper:
        return None
    o, (name, _, by_value) = g.random.choice(usable)
    made = g.local("e")
    g.line(f"double {made} = {name}({'' if by_value else '&'}{o.text});")
    g.declare(Variable(made, DOUBLE, -1000.0, 1000.0, True))
    return True
