"""Functions that return an object of numbers: by value, in C through a hidden pointer, in C++ also from braces and by conversions."""
from dataclasses import dataclass

from .arithmetic import DOUBLE
from .generator import Variable
from .expression import Expression


@dataclass
class Returned:
    """Its type; its numbers as the caller reads them; a return's expression; how a local of that type gets them, if it may."""
    type: str
    read: list
    text: str
    local: str = ""


def form(g):
    name = g.outer("both")
    compound = f"(struct {name})" if g.language == "c" else g.among("", f"{name}")
    keyword = "struct " if g.language == "c" else g.among("struct ", "")
    n = g.whole(1, 3)
    places = [f"v[{k}]" for k in range(n)]
    numbers = ", ".join("@" for _ in range(n))
    sets = "".join(f" made.{p} = @;" for p in places)
    forms = [
        lambda: (g.define(f"struct {name} {{ double a; double b; }};"),
                 Returned(keyword + name, ["result.a", "result.b"], f"{compound}{{@, @}}", "made.a = @; made.b = @;")),
        lambda: (g.define(f"struct {name} {{ double a; double v[{n}]; }};"),
                 Returned(keyword + name, ["result.a"] + [f"result.{p}" for p in places], f"{compound}{{@, {{{numbers}}}}}", f"made.a = @;{sets}")),
        lambda: (g.define(f"struct {name} {{ double v[{n}]; }};"),
                 Returned(keyword + name, [f"result.{p}" for p in places], f"{compound}{{{{{numbers}}}}}", sets.strip())),
        lambda: (g.define(f"struct {name} {{ struct {{ double x, y; }} at[2]; double t; }};"),
                 Returned(keyword + name, [f"result.at[{k}].{m}" for k in (0, 1) for m in "xy"] + ["result.t"],
                          f"{compound}{{{{{{@, @}}, {{@, @}}}}, @}}",
                          "".join(f"made.at[{k}].{m} = @; " for k in (0, 1) for m in "xy") + "made.t = @;"))]
    if g.language == "cxx":
        elements = [f"result[{k}]" for k in range(n)]
        many = "".join(f"made[{k}] = @; " for k in range(n)).strip()
        forms += [
            lambda: (None, Returned(f"std::array<double, {n}>", elements, f"{{{numbers}}}", many)),
            lambda: (None, Returned("std::vector<double>", elements, f"{{{numbers}}}", f"made.resize({n}); {many}")),
            lambda: (None, Returned("std::vector<double>", elements, f"std::vector<double>{{{numbers}}}",
                                    "".join("made.push_back(@); " for _ in range(n)).strip())),
            lambda: (None, Returned("std::pair<double, double>", ["result.first", "result.second"],
                                    g.among("{@, @}", "std::make_pair(@, @)"), "made.first = @; made.second = @;")),
            lambda: (None, Returned("std::complex<double>", ["result.real()", "result.imag()"],
                                    g.among("{@, @}", "std::complex<double>(@, @)"), "made = std::complex<double>(@, @);")),
            lambda: (None, Returned("std::complex<double>", ["result.real()", "result.imag()"], "@")),
            lambda: (g.define(f"struct {name} {{ double a; {name}(double z) : a(z) {{}} }};"), Returned(name, ["result.a"], "@")),
            lambda: (g.define(f"struct {name} {{ std::array<double, {n}> list; double t; }};"),
                     Returned(name, [f"result.list[{k}]" for k in range(n)] + ["result.t"], f"{{{{{numbers}}}, @}}",
                              "".join(f"made.list[{k}] = @; " for k in range(n)) + "made.t = @;")),
            lambda: (None, Returned(f"std::pair<std::array<double, {n}>, double>", [f"result.first[{k}]" for k in range(n)] + ["result.second"],
                                    f"{{{{{numbers}}}, @}}", "".join(f"made.first[{k}] = @; " for k in range(n)) + "made.second = @;")),
            lambda: (None, Returned(f"std::array<std::array<double, 2>, {n}>", [f"result[{k}][{j}]" for k in range(n) for j in (0, 1)],
                                    "{{" + ", ".join("{@, @}" for _ in range(n)) + "}}"))]
    return g.random.choice(forms)()[1]


def returned_objects(g, made):
    """The form of an interface: numbers come in, the object goes out."""
    for _ in range(g.whole(1, 3)):
        name = g.local("x")
        made.parameters.append(f"double {name}")
        made.arguments.append(name)
        made.objects.append(f"double {name};")
        made.inputs.append((name, [name]))
        g.declare(Variable(name, DOUBLE, *((made.low, made.high) if made.tame else (None, None)), True, False))
        g.inputs.append(Expression(name, 16, DOUBLE, *((made.low, made.high) if made.tame else (None, None)), True))
    made.returned = form(g)
    made.result = made.returned.type
    made.outputs.append(("return", made.returned.read))
    return []


def filled(pattern, values):
    for text in values:
        pattern = pattern.replace("@", text.replace("@", ""), 1)
    return pattern


def expression(g, returned, value):
    """The expression behind `return`."""
    return filled(returned.text, [value(g) for _ in range(returned.text.count("@"))])


def last_lines(g, returned, value):
    if not returned.local or g.chance(0.5):
        return [f"return {expression(g, returned, value)};"]
    values = [value(g) for _ in range(returned.local.count("@"))]
    return [f"{returned.type} made;", filled(returned.local, values), "return made;"]
