"""An expression: its text, how tightly it binds, its type, its values, and whether it depends on an input."""
from dataclasses import dataclass
from math import isfinite

from .arithmetic import DOUBLE, FLOAT

PRIMARY, POSTFIX, UNARY, MULTIPLY, ADD, SHIFT, RELATION, EQUALITY = 16, 15, 14, 12, 11, 10, 9, 8
BIT_AND, BIT_XOR, BIT_OR, AND, OR, CONDITION, ASSIGN, COMMA = 7, 6, 5, 4, 3, 2, 1, 0

PRECEDENCE = {"*": MULTIPLY, "/": MULTIPLY, "%": MULTIPLY, "+": ADD, "-": ADD, "<<": SHIFT, ">>": SHIFT,
              "<": RELATION, ">": RELATION, "<=": RELATION, ">=": RELATION, "==": EQUALITY, "!=": EQUALITY,
              "&": BIT_AND, "^": BIT_XOR, "|": BIT_OR, "&&": AND, "||": OR}


@dataclass
class Expression:
    """`low` and `high` are None for a number of which nothing is known: it may be infinite or a NaN."""
    text: str
    binds: int
    type: object
    low: object
    high: object
    symbolic: bool

    def at(self, binding):
        return self.text if self.binds >= binding else f"({self.text})"

    @property
    def is_number(self):
        return self.type in (DOUBLE, FLOAT)

    @property
    def tame(self):
        return self.low is not None

    @property
    def interval(self):
        return self.low, self.high


def number(text, binds, interval, symbolic):
    """A double; one that may become large is one of which nothing is known."""
    low, high = interval if interval else (None, None)
    if low is not None and not (isfinite(low) and isfinite(high) and max(abs(low), abs(high)) < 1e12):
        low = high = None
    return Expression(text, binds, DOUBLE, low, high, symbolic)


def joined(operator, left, right):
    """The text of `left operator right`, with the parentheses that it needs."""
    binding = PRECEDENCE[operator]
    return f"{left.at(binding)} {operator} {right.at(binding + 1)}"
