"""One kernel while it is made: its names, its scope, its text as a tree of statements, and the choice of productions.

A production is a function that gets the generator and a depth and gives an Expression, or True for a statement, or None
where it does not apply. Values are kept where the language defines what happens: each variable has an interval that every
assignment to it stays within.
"""
import random
from contextlib import contextmanager
from dataclasses import dataclass, field

from .arithmetic import DOUBLE

PRODUCTIONS = {"number": [], "integer": [], "condition": [], "statement": [], "definition": []}


def production(kind, weight, feature=None, language=None):
    def register(function):
        PRODUCTIONS[kind].append((function, weight, feature, language))
        return function
    return register


@dataclass
class Variable:
    text: str
    type: object
    low: object
    high: object
    symbolic: bool
    writable: bool = True
    plain: bool = False  # only plain values are assigned: it may bound a loop under every policy
    binds: int = 16


@dataclass
class Array:
    text: str
    size: int
    type: object
    low: object
    high: object
    symbolic: bool
    writable: bool = True
    table: bool = False
    container: bool = False


@dataclass
class Block:
    header: str
    children: list = field(default_factory=list)
    footer: str = "}"


@dataclass
class Function:
    text: str
    parameters: list  # (type, low, high)
    type: object
    low: object
    high: object
    symbolic: bool = False
    deduced: bool = False  # an argument of another type would change what it is


class Generator:
    def __init__(self, name, seed, language, policy, mode, features):
        self.random = random.Random(seed)
        self.name, self.language, self.policy, self.mode, self.features = name, language, policy, mode, features
        self.count = 0
        self.definitions = []   # before the kernel, in file scope
        self.body = []          # of the function that is being written
        self.scopes = [[]]      # Variables and Arrays; the first is file scope
        self.functions = []
        self.decides = policy != "error" or self.has("decisions")
        self.plain = 0          # > 0: what is made must not depend on an input
        self.loops = 0
        self.in_helper = False
        self.returns = None     # of a helper: what its early returns give
        self.inputs = []        # as expressions
        self.result = self.kernel_result = None  # what gives a value to return
        self.enumerations, self.structs, self.readers = [], [], []
        self.function_tables, self.function_takers = [], []
        self.shown = []         # variables that an output must depend on: compilers leave out unread ones
        self.expected = set()   # diagnostics, of which the tool must give one
        self.idioms, self.statements_of_idioms = [], []
        self.indices = 0        # how many computed indices stand around what is made

    # Chance.
    def chance(self, probability):
        return self.random.random() < probability

    def among(self, *choices):
        return self.random.choice(choices)

    def whole(self, low, high):
        return self.random.randint(low, high)

    def has(self, feature):
        return feature is None or feature in self.features

    def choose(self, kind, depth, attempts=6):
        """What one of the productions gives that apply here, or None."""
        usable = [(function, weight) for function, weight, feature, language in PRODUCTIONS[kind]
                  if self.has(feature) and language in (None, self.language)]
        for _ in range(attempts if usable else 0):
            function = self.random.choices([p[0] for p in usable], [p[1] for p in usable])[0]
            made = function(self, depth)
            if made is not None and not (self.plain and made is not True and made.symbolic):
                return made
        return None

    # Names.
    def local(self, stem):
        self.count += 1
        return f"{stem}{self.count}"

    def outer(self, stem):
        self.count += 1
        return f"{self.name}_{stem}{self.count}"

    # Text.
    def line(self, text):
        self.body.append(text)

    @contextmanager
    def block(self, header, footer="}"):
        made = Block(header, [], footer)
        outside, self.body = self.body, made.children
        self.scopes.append([])
        yield made
        self.scopes.pop()
        self.body = outside
        self.body.append(made)

    def define(self, text):
        self.definitions.append(text)

    # Scope.
    def declare(self, thing):
        self.scopes[-1].append(thing)
        return thing

    def visible(self):
        return [thing for scope in self.scopes for thing in scope]

    def variables(self, is_wanted, writable=False):
        return [v for v in self.visible() if isinstance(v, Variable) and is_wanted(v)
                and not (self.plain and v.symbolic) and not (writable and not v.writable)]

    def arrays(self, is_wanted, writable=False):
        return [a for a in self.visible() if isinstance(a, Array) and is_wanted(a)
                and not (self.plain and a.symbolic) and not (writable and not a.writable)]

    @contextmanager
    def only_plain(self, wanted=True):
        self.plain += wanted
        yield
        self.plain -= wanted

    @contextmanager
    def function_scope(self):
        """Inside of another function: only file scope is visible."""
        kept = self.scopes, self.body, self.in_helper, self.returns, self.loops, self.plain
        self.scopes, self.body, self.in_helper, self.returns, self.loops, self.plain = \
            [[t for t in self.scopes[0]], []], [], True, [], 0, 0
        yield self.body
        self.scopes, self.body, self.in_helper, self.returns, self.loops, self.plain = kept

    def math(self, name):
        return ("std::" if self.language == "cxx" and self.chance(0.7) else "") + name


def is_double(thing):
    return thing.type == DOUBLE


def is_integer(thing):
    return not isinstance(thing.type, str)
