"""The text of a graph, its operations, and its outputs in double precision and with forty digits."""
import decimal
import math
import re

decimal.getcontext().prec = 40
NODE = re.compile(r"%(\d+) = (\w+) (.*)")


PARAMETERS = re.compile(r"parameter .* = (.*)")
ARITHMETIC = ("add", "sub", "mul", "div")


def read(text):
    """The nodes, each an operation and its operands, and the operands that are results."""
    nodes, results = {}, []
    for line in text.splitlines():
        if match := NODE.match(line):
            operands = re.sub(r"@.*", "", match[3]).split()
            nodes[int(match[1])] = (match[2], operands)
        elif line.startswith("result "):
            results.append(line.split()[2])
    return nodes, results


def operations(text):
    """Of `compute`: what depends on an input."""
    variable, count = set(), 0
    for name, (operation, operands) in read(text)[0].items():
        if operation == "input" or any(operand[0] == "%" and int(operand[1:]) in variable for operand in operands):
            variable.add(name)
            count += operation in ARITHMETIC
    return count


def sine(x, shift=0):
    """Of a Decimal, by its series; with a shift of 1 the cosine."""
    term = decimal.Decimal(1) if shift else x
    total, k = term, 0 if shift else 1
    while abs(term) > decimal.Decimal("1e-45"):
        term *= -x * x / ((k + 1) * (k + 2))
        total, k = total + term, k + 2
    return total


def evaluate(text, inputs, number, sin, cos):
    nodes, results = read(text)
    parameters = [word for line in text.splitlines() if (match := PARAMETERS.match(line)) for word in match[1].split()]
    values = {}

    def value(operand):
        return values[int(operand[1:])] if operand[0] == "%" else number(float(operand))

    functions = {
        "add": lambda x, y: x + y, "sub": lambda x, y: x - y, "mul": lambda x, y: x * y, "div": lambda x, y: x / y,
        "neg": lambda x: -x, "sin": sin, "cos": cos,
    }
    for name, (operation, operands) in nodes.items():
        if operation == "input":
            values[name] = number(inputs[int(operands[0])])
        elif operation == "parameter":
            values[name] = number(float(parameters[int(operands[0])]))
        else:
            values[name] = functions[operation](*map(value, operands))
    return [value(result) for result in results]


def in_double(text, inputs):
    return evaluate(text, inputs, float, math.sin, math.cos)


def in_forty_digits(text, inputs):
    return evaluate(text, inputs, decimal.Decimal, sine, lambda x: sine(x, 1))
