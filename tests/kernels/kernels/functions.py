"""Functions of the kernel's own, and calls of them."""
from .arithmetic import DOUBLE, INT, SPELLINGS
from .expression import POSTFIX, Expression, number
from .generator import Block, Function, Variable, production
from .integers import bounded, integer
from .numbers import some_number, tame_number
from .statements import fitting, fitting_number, integer_type, spelled, statements


def make_function(g, type=None):
    """A function of numbers and integers, whose result depends on nothing else."""
    name = g.outer(g.among("f", "law", "part"))
    type = type or (DOUBLE if not g.has("integers") or g.chance(0.65) else integer_type(g))
    parameters = []
    for _ in range(g.whole(1, 3)):
        if g.has("integers") and g.chance(0.4):
            kind = integer_type(g)
            parameters.append((kind, *((-100, 100) if kind.signed else (0, min(kind.high, 10 ** 6)))))
        else:
            parameters.append((DOUBLE, *((None, None) if g.has("wild") and g.chance(0.3) else (-50.0, 50.0))))
    with g.function_scope() as body:
        names = []
        for kind, low, high in parameters:
            variable = Variable(g.local("z"), kind, low, high, True, g.chance(0.7))
            g.declare(variable)
            names.append(f"{'double' if kind == DOUBLE else spelled(g, kind)} {variable.text}")
        reach = 1000

        def result(g):
            if type == DOUBLE:
                return some_number(g, 2)
            return fitting(g, integer(g, 2), type, max(type.low, -reach), min(type.high, reach))

        outer_result = g.result
        g.result = result
        statements(g, g.whole(0, 3), 1)
        made = result(g)
        g.line(f"return {made.text};")
        g.result = outer_result
        results = g.returns + [made]
    spelling = "double" if type == DOUBLE else spelled(g, type)
    qualifier = g.among("static ", "static ", "static inline ")
    g.definitions.append(Block(f"{qualifier}{spelling} {name}({', '.join(names)}) {{", list(body)))
    if type == DOUBLE:
        tame = all(r.tame for r in results)
        interval = (min(r.low for r in results), max(r.high for r in results)) if tame else (None, None)
    else:
        interval = max(type.low, -reach), min(type.high, reach)
        if not type.signed:
            interval = 0, min(type.high, max(reach, *(r.high for r in results)))
    function = Function(name, parameters, type, *interval)
    g.functions.append(function)
    return function


def called(g, depth, is_wanted):
    """A call of a function that there is already, so none calls itself."""
    usable = [f for f in g.functions + g.visible() if isinstance(f, Function) and is_wanted(f)]
    if not usable:
        return None
    function = g.random.choice(usable)
    texts, symbolic = [], False
    for type, low, high in function.parameters:
        if type == DOUBLE:
            if g.has("integer_arguments") and g.chance(0.25) and low is not None and not function.deduced:
                made = bounded(g, integer(g, depth - 1), -50, 50)
            else:
                made = fitting_number(g, depth - 1, low, high)
        else:
            made = bounded(g, integer(g, depth - 1), low, high)
        texts.append(made.text)
        symbolic = symbolic or made.symbolic
    text = f"{function.text}({', '.join(texts)})"
    symbolic = symbolic or function.symbolic
    if function.type == DOUBLE:
        interval = (function.low, function.high) if function.low is not None else None
        return number(text, POSTFIX, interval, symbolic)
    return Expression(text, POSTFIX, function.type, function.low, function.high, symbolic)


@production("definition", 4, "helpers")
def definition(g, depth):
    make_function(g)
    return True
