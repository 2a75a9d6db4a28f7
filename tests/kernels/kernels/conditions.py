"""Conditions: of numbers, of integers, of both, joined and negated. In C they are of type int."""
from .arithmetic import BOOL, INT
from .expression import AND, EQUALITY, OR, POSTFIX, RELATION, UNARY, Expression, joined
from .generator import production
from .integers import integer
from .numbers import any_number, constant


def truth(g, text, binds, symbolic):
    return Expression(text, binds, INT if g.language == "c" else BOOL, 0, 1, symbolic)


def condition(g, depth):
    if g.policy == "error" and not g.decides or g.chance(0.15):
        with g.only_plain():
            return g.choose("condition", depth) or of_integers(g, 0)
    return g.choose("condition", depth) or of_integers(g, 0)


@production("condition", 8)
def of_numbers(g, depth):
    operator = g.among("<", ">", "<=", ">=", "<", ">", "==", "!=")
    left = any_number(g, depth - 1)
    right = constant(g) if g.chance(0.5) else any_number(g, depth - 1)
    if g.has("integers") and g.chance(0.2):
        right = integer(g, 0)
    return truth(g, joined(operator, left, right), EQUALITY if operator in ("==", "!=") else RELATION,
                 left.symbolic or right.symbolic)


@production("condition", 5, "integers")
def of_integers(g, depth):
    operator = g.among("<", ">", "<=", ">=", "==", "!=")
    left, right = integer(g, depth - 1), integer(g, depth - 1)
    return truth(g, joined(operator, left, right), EQUALITY if operator in ("==", "!=") else RELATION,
                 left.symbolic or right.symbolic)


@production("condition", 2)
def both(g, depth):
    if depth <= 0:
        return None
    operator = g.among("&&", "||")
    left, right = condition(g, depth - 1), condition(g, depth - 1)
    return truth(g, joined(operator, left, right), AND if operator == "&&" else OR, left.symbolic or right.symbolic)


@production("condition", 1)
def negated(g, depth):
    inner = condition(g, depth - 1)
    return truth(g, f"!{inner.at(POSTFIX)}", UNARY, inner.symbolic)


@production("condition", 1, "bare_conditions")
def bare(g, depth):
    inner = integer(g, depth - 1) if g.chance(0.5) else any_number(g, depth - 1)
    return truth(g, f"!{inner.at(POSTFIX)}", UNARY, inner.symbolic)
