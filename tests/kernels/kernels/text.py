"""Text: numbers that are printed for a log, and those that come back from it, which is an error or right."""
from .arithmetic import DOUBLE, INT
from .generator import Variable, production
from .integers import integer
from .numbers import tame_number


def print_into(g, name):
    made = tame_number(g, 1, 1000)
    if g.has("integers") and g.chance(0.3):
        g.line(f'snprintf({name}, sizeof {name}, "%d", (int)({integer(g, 1).text}));')
    elif g.chance(0.5):
        g.line(f'snprintf({name}, sizeof {name}, "{g.among("%g", "%.3f", "%e", "v=%6.2f")}", {made.text});')
    else:
        g.line(f'sprintf({name}, "{g.among("%g", "%.3f")} %d", {made.text}, {g.whole(0, 9)});')


@production("statement", 2, "text")
def log(g, depth):
    name = g.local("line")
    g.line(f"char {name}[64];")
    print_into(g, name)
    return True


@production("statement", 2, "text_read_back")
def round_trip(g, depth):
    name, made = g.local("line"), g.local("r")
    g.line(f"char {name}[64];")
    value = tame_number(g, 1, 1000)
    how = g.whole(0, 4)
    g.line(f'snprintf({name}, sizeof {name}, "%.3f", {value.text});' if how != 1 else
           f'int {made}n = snprintf({name}, sizeof {name}, "%g", {value.text});')
    g.line(f"double {made} = " + (f"atof({name});", f"{made}n;", f"{name}[0] == '-';", f"strtod({name}, 0);",
                                  f"(double)strlen({name});")[how])
    g.declare(Variable(made, DOUBLE, -1001.0, 1001.0, True))
    return True
