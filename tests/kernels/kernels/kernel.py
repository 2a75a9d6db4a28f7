"""A kernel: the text of one function and of all that is its own, and what is needed to call it."""
import random
from dataclasses import dataclass

from . import classes, function_values, functions, library, objects, templates, text  # noqa: F401: they register their productions
from .features import drawn
from .generator import Block, Generator
from .interface import Interface, make_interface
from .arithmetic import DOUBLE
from .expression import ADD, joined, number
from .memory import declare_memory
from .numbers import any_number, some_number
from .parts import declare_parts
from .plain import declare_plain
from .returned import expression, last_lines
from .state import declare_state
from .statics import declare_statics
from .statements import statements


@dataclass
class Kernel:
    name: str
    seed: str
    nodes: list          # file scope, as a tree of text
    interface: Interface
    recorded: list       # inputs, then parameters
    features: set
    expected: set        # diagnostics, one of which the tool must give; where it is empty, none that is not of the policy

    @property
    def text(self):
        return "".join(line + "\n" for line in flat(self.nodes))


def flat(nodes, depth=0):
    for node in nodes:
        if isinstance(node, str):
            yield "  " * depth + node if not node.startswith("#") else node
        else:
            yield "  " * depth + node.header
            yield from flat(node.children, depth + 1)
            if node.footer is not None:
                yield "  " * depth + node.footer


def make_kernel(name, seed, language, policy, mode, excluded=(), often=()):
    features = drawn(random.Random(f"features {seed}"), language, int(seed.split("/")[-1]), excluded, often)
    g = Generator(name, seed, language, policy, mode, features)
    for _ in range(g.whole(0, 4)):
        g.choose("definition", 2)
    interface, written = write_body(g)
    return Kernel(name, seed, g.definitions, interface, recorded_inputs(g, interface), features, g.expected)


def write_body(g):
    g.scopes.append([])
    interface, written = make_interface(g)
    for declare in (declare_plain, declare_state, declare_statics, declare_memory, declare_parts):
        declare(g, interface)
    if interface.returned:
        g.returns = []
        g.kernel_result = lambda g: expression(g, interface.returned, lambda g: some_number(g, 2).text)
    elif interface.result == "double":
        g.returns = []
        g.kernel_result = lambda g: some_number(g, 2).text
    elif not g.has("unwritten_outputs"):
        # Early returns leave nothing unwritten.
        if g.has("returns"):
            for text in written:
                if not any(text in elements for _, elements in interface.inputs):
                    g.line(f"{text} = {some_number(g, 1).at(ADD)} + {g.random.choice(g.inputs).text};")
            g.returns = []
    else:
        g.returns = []
    statements(g, g.whole(2, 8), 3)
    for text in written:
        made = observed(g)
        if g.has("unwritten_outputs") and g.chance(0.5):
            with g.block(f"if ({some_number(g, 1).text} > 0) {{"):
                g.line(f"{text} = {made.text};")
        else:
            g.line(f"{text} {g.among('+=', '-=') if g.has('returns') and g.chance(0.2) and not g.has('unwritten_outputs') else '='} {made.text};")
    keep_dependent(g, interface)
    if interface.returned:
        for line in last_lines(g, interface.returned, lambda g: observed(g).text):
            g.line(line)
    elif interface.result == "double":
        g.line(f"return {observed(g).text};")
    header = f"{interface.result} {g.name}({', '.join(interface.parameters)}) {{"
    g.definitions.append(pragma(interface))
    g.definitions.append(Block(header, g.body))
    return interface, written


def keep_dependent(g, interface):
    """State that was assigned may be a constant by now, which is an error."""
    outputs = {element for _, elements in interface.outputs for element in elements}
    lines = [line.strip() for line in flat(g.body)]
    for _, elements in interface.inputs:
        for element in elements:
            if element.startswith(g.name) and element in outputs and any(line.startswith(element.split("[")[0]) for line in lines):
                g.line(f"{element} = 0.5 * {element} + 0.25 * {g.random.choice(g.inputs).text};")


def observed(g):
    """A value that shows what became of the variables."""
    made = any_number(g, 2)
    # An output that depends on no input is an error.
    made = number(joined("+", made, g.random.choice(g.inputs)), ADD, None, True)
    while g.shown:
        made = number(f"{made.at(ADD)} + {g.shown.pop()}", ADD, None, True)
    for variable in g.variables(lambda v: v.writable or v.type != DOUBLE)[-6:]:
        if variable.low != variable.high and g.chance(0.6):
            factor = g.among("", "", "0.5 * ", "3 * ") if variable.type == DOUBLE else g.among("0.5 * ", "1e-3 * ", "")
            made = number(f"{made.at(ADD)} {g.among('+', '-')} {factor}{variable.text}", ADD, None, True)
    return made


def pragma(interface):
    low, high = interface.low, interface.high
    words = ["#pragma symreal function"]
    words.append(f"input({', '.join(text for text, _ in interface.inputs)})")
    if interface.tame:
        words.append(f"range({low}, {high})")
    if interface.values:
        words.append(f"parameter({', '.join(text for text, _ in interface.values)})")
        words.append(f"range({low}, {high})")
    words += interface.clauses
    words.append(f"output({', '.join(text for text, _ in interface.outputs)})")
    return " ".join(words)


def recorded_inputs(g, interface):
    count = sum(len(elements) for _, elements in interface.inputs + interface.values)
    return [round(g.random.uniform(interface.low, interface.high), g.among(1, 2, 3)) for _ in range(count)]
