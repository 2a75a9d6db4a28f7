"""Bytes of numbers: whole numbers are moved by bytes and unions, which is right; parts of symbolic ones are not."""
from .arithmetic import DOUBLE, INT
from .expression import ADD
from .generator import Variable, production
from .numbers import tame_number

DIAGNOSED = {"SYM199", "SYM035"}


def cell(g):
    """The union of this kernel."""
    name = f"{g.name}_cell"
    if not any(name in d for d in g.definitions if isinstance(d, str)):
        g.define(f"union {name} {{ double number; unsigned words[2]; unsigned long long all; unsigned char bytes[8]; }};")
    made = g.local("cell")
    g.line(f"union {name} {made};")
    return made


@production("statement", 4, "parts")
def whole_number(g, depth):
    if g.in_helper:
        return None  # the union is defined after it
    made = g.local("w")
    value = tame_number(g, 2, 100)
    how = g.whole(0, 5)
    low, high, symbolic = value.low, value.high, True
    if how == 0:
        name = cell(g)
        g.line(f"{name}.number = {value.text};")
        g.line(f"double {made} = {name}.number;")
    elif how == 1:
        g.line(f"double {made}, {made}_from = {value.text};")
        g.line(f"memcpy(&{made}, &{made}_from, sizeof {made});")
    elif how == 2:
        g.line(f"double {made} = {value.text};")
        g.line(f"memset(&{made}, 0, {g.among(f'sizeof {made}', '8', 'sizeof(double)')});")
        low = high = 0.0
    elif how == 3:
        name = cell(g)
        g.line(f"{name}.number = {value.text};")
        g.line(f"{name}.words[0] = {g.whole(0, 9)}u;")
        g.line(f"{name}.words[1] = 0x3ff80000u;")
        g.line(f"double {made} = {name}.number;")
        low, high = 1.5, 1.6
    elif how == 4:
        name = cell(g)
        g.line(f"{name}.number = 2.5;")
        g.line(f"{name}.words[1] ^= 0x80000000u;")
        g.line(f"double {made} = {name}.number;")
        low = high = -2.5
    else:
        name = cell(g)
        g.line(f"{name}.number = 2.5;")
        g.line(f"double {made} = (int)({name}.words[1] >> 20) - 1023;")
        low = high = 1.0
    g.declare(Variable(made, DOUBLE, min(low, 0.0), max(high, 0.0), symbolic))
    return True


def declare_parts(g, made):
    """A part of a symbolic number, which is surely met, and used."""
    if not g.has("parts_written") or not g.chance(0.7):
        return
    name = g.local("part")
    value = f"{g.random.choice(g.inputs).at(ADD)} + {tame_number(g, 1, 4).at(ADD)}"
    how = g.whole(0, 7)
    if how <= 2:
        union = cell(g)
        g.line(f"{union}.number = {value};")
        g.line(g.among(f"{union}.words[0] = 0;", f"{union}.words[0] = 7;", f"{union}.words[1] = 0x3ff80000u;", f"{union}.bytes[7] = 0x40;",
                       f"{union}.words[1] ^= 0x80000000u;", f"{union}.all &= ~1ull;", f"{union}.bytes[0]++;"))
        g.line(f"double {name} = {union}.number;")
    elif how == 3:
        g.line(f"double {name} = {value}, {name}_from = 1.5;")
        g.line(g.among(f"memcpy(&{name}, &{name}_from, 4);", f"memcpy((char *)&{name} + 4, (char *)&{name}_from + 4, 4);"))
    elif how == 4:
        g.line(f"double {name} = {value};")
        g.line(f"memset(&{name}, {g.among('0', '1')}, {g.among('4', '1', '7')});")
    elif how == 5:
        g.line(f"double {name} = {value};")
        g.line(f"((unsigned char *)&{name})[{g.whole(0, 7)}] = {g.whole(0, 3)};")
    elif how == 6:
        union = cell(g)
        g.line(f"{union}.number = {value};")
        g.line(f"double {name} = {g.among(f'{union}.words[1] >> 31', f'{union}.words[0] & 1', f'{union}.bytes[7]', f'{union}.all % 3')};")
    else:
        g.line(f"double {name}_from = {value}; unsigned {name}_half;")
        g.line(f"memcpy(&{name}_half, &{name}_from, 4);")
        g.line(f"double {name} = {name}_half & 1;")
    g.shown.append(name)
    g.expected |= DIAGNOSED
