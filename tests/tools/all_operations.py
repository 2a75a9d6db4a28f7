#!/usr/bin/env python3
"""all_operations.py OPERATIONS.DEF: prints a graph with every operation of the table, each on inputs of its own, without
those that need more than their operands. With --inputs K: instead the inputs of run K, numbers of the operation's domain
or corner values, separated by blanks; with --finite behind the table none that is infinite, or no number. With --real float
at the end: the operations and numbers that single precision has."""
import math
import random
import re
import sys

ROW = re.compile(r'^OPERATION\((\w+), (\d), (\w+), "([^"]*)", (\d+), .*, ([\w |]+), (\w+), "[^"]*"\)$')


def rows(path):
    for line in open(path):
        if line.startswith("OPERATION("):
            name, arity, form, _, _, flags, domain = ROW.match(line).groups()
            is_beyond = "WIDE" in flags or "TAKES_WIDE" in flags or name in ("mul_uint32", "wrap_int32", "wrap_uint32")
            if "OPAQUE" not in flags and not (is_float and is_beyond):
                yield name, int(arity), form, set(flags.split(" | ")), domain


def takes_wide(form, flags, operand):
    return "TAKES_WIDE" in flags and not (form == "select" and operand == 0)


def graph(path):
    nodes, results, count, inputs = [], [], 0, 0

    def node(text):
        nonlocal count
        nodes.append(f"%{count} = {text}")
        count += 1
        return count - 1

    outputs = []
    for name, arity, form, flags, _ in rows(path):
        operands = [node(f"input {inputs + i}") for i in range(arity)]
        inputs += arity
        operands = [node(f"wide_int %{x}") if takes_wide(form, flags, i) else x for i, x in enumerate(operands)]
        value = node(" ".join([name] + [f"%{x}" for x in operands]))
        if "WIDE" in flags:
            value = node(f"wide_value %{value}")
        results.append(f"result {len(results)} %{value}")
        outputs.append(f'output "op_{name}"')
    print('symreal-graph 1\nkernel "k"\ninput "x" [%d]' % inputs)
    print("\n".join(outputs + nodes + results))


CORNERS = [0.0, -0.0, 1.0, -1.0, 0.5, -0.5, 2.5, -1.5, 1e300, -1e300, 5e-324, -2.2250738585072014e-308, float("inf"),
           -float("inf"), float("nan"), 4503599627370495.5, 0.49999999999999994]


# The same places among floats.
FLOAT_CORNERS = [0.0, -0.0, 1.0, -1.0, 0.5, -0.5, 2.5, -1.5, 3e38, -3e38, 1.4e-45, -1.1754944e-38, float("inf"),
                 -float("inf"), float("nan"), 8388607.5, 0.49999997]


def draw(domain, source):
    x = source.uniform(-1, 1)
    return {"any": 5 * x, "positive": 0.1 + 4 * abs(x), "unit": 0.95 * x, "above_one": 1.1 + 4 * abs(x),
            "integer": float(int(x * 2.0 ** source.randrange(63)))}[domain]


def numbers(path, run, corners):
    source = random.Random(run)
    for name, arity, form, flags, domain in rows(path):
        for operand in range(arity):
            if "LOGICAL" in flags or (form == "select" and operand == 0):
                yield float(source.randrange(2))
            elif domain == "integer" or run < 3:
                yield draw(domain, source)
            else:
                yield source.choice(corners)


is_float = sys.argv[-2:] == ["--real", "float"]
if is_float:
    del sys.argv[-2:]
if len(sys.argv) >= 4 and sys.argv[1] == "--inputs":
    corners = FLOAT_CORNERS if is_float else CORNERS
    corners = [x for x in corners if math.isfinite(x)] if "--finite" in sys.argv else corners
    print(*(repr(x) for x in numbers(sys.argv[3], int(sys.argv[2]), corners)))
else:
    graph(sys.argv[1])
