"""Reads the Maple that Symreal writes by a grammar of it, and runs it on doubles, as the option hfloat of procedures has it.
What is no Maple is an error here: a sign behind an operator, powers of powers, a name that is set and not declared."""
import ctypes
import fractions
import math
import os
import re
import struct
import types

TOKEN = re.compile(r'\s+|#.*|(?P<number>\d+(?:\.(?!\.)\d*)?(?:[eE][-+]?\d+)?)|(?P<name>[A-Za-z_]\w*|`[^`]*`)|'
                   r'(?P<string>"(?:\\.|[^"\\])*")|(?P<mark>:=|:-|\.\.|<=|>=|<>|[-+*/^<>=()\[\],;:\'])')
WORDS = {"and", "or", "not", "if", "then", "elif", "else", "end", "proc", "local", "option", "return", "error", "for", "to", "do",
         "try", "catch", "read"}


def tokens(text):
    at, found = 0, []
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise SyntaxError(f"no Maple: {text[at:at + 40]!r}")
        at = match.end()
        if match.lastgroup:
            found.append((match.lastgroup, match[0]))
    return found + [("end", "")]


class Reader:
    """Turns Maple into Python."""

    def __init__(self, text):
        self.tokens, self.at, self.declared = tokens(text), 0, None

    def peek(self):
        return self.tokens[self.at][1]

    def take(self, *wanted):
        kind, text = self.tokens[self.at]
        if wanted and text not in wanted:
            raise SyntaxError(f"{' or '.join(wanted)} is wanted before {' '.join(t for _, t in self.tokens[self.at:self.at + 8])}")
        self.at += 1
        return text

    def accept(self, text):
        if self.peek() != text:
            return False
        self.at += 1
        return True

    def name(self, text):
        return "_" + text.strip("`").replace("-", "_") if text.startswith("`") else "m_" + text

    def items(self, closing):
        found = []
        while not self.accept(closing):
            if found:
                self.take(",")
            if self.peek() == "datatype":
                self.take(), self.take("=")
                self.expression()
                found.append("datatype=" + self.tokens[self.at - 2][1])
            else:
                value = self.expression()
                found.append(("*" if value.startswith("m_op(") else "") + value)
        return ", ".join(found)

    def primary(self):
        kind, text = self.tokens[self.at]
        self.at += 1
        if kind == "number" or kind == "string":
            value = text
        elif text == "(":
            value = f"({self.expression()})"
            self.take(")")
        elif text == "[":
            value = f"One([{self.items(']')}])"
        elif kind == "name" and text not in WORDS:
            value = self.name(text)
        else:
            raise SyntaxError(f"no operand: {text} {self.peek()}")
        while self.peek() in ("(", "[", ":-"):
            mark = self.take()
            if mark == ":-":
                value += "." + self.take()
            elif mark == "[":
                value += f"[{self.items(']')}]"
            elif value == "_if":
                condition, yes, no = self.expression(), self.take(",") and self.expression(), self.take(",") and self.expression()
                self.take(")")
                value = f"({yes} if {condition} else {no})"
            else:
                value += f"({self.items(')')})"
        return value

    def power(self):
        value = self.primary()
        if self.accept("^"):
            value = f"power({value}, {self.primary()})"
            if self.peek() == "^":
                raise SyntaxError("a power of a power")
        return value

    def product(self):
        value = self.power()
        while self.peek() in ("*", "/"):
            value = f"({value}*{self.power()})" if self.take() == "*" else f"quotient({value}, {self.power()})"
        return value

    def sum(self):
        value = f"(-{self.product()})" if self.accept("-") else self.product()
        while self.peek() in ("+", "-"):
            value = f"({value} {self.take()} {self.product()})"
        return value

    def relation(self):
        value = self.sum()
        if self.accept(".."):
            return f"slice({value}, {self.sum()})"
        if self.peek() in ("<", "<=", ">", ">=", "=", "<>"):
            mark = {"=": "==", "<>": "!="}.get(self.peek(), self.peek())
            self.take()
            value = f"({value} {mark} {self.sum()})"
        return value

    def negation(self):
        return f"(not {self.negation()})" if self.accept("not") else self.relation()

    def conjunction(self):
        value = self.negation()
        while self.accept("and"):
            value = f"({value} and {self.negation()})"
        return value

    def expression(self):
        value = self.conjunction()
        while self.accept("or"):
            value = f"({value} or {self.conjunction()})"
        return value

    def block(self, indent, *ends):
        """Statements up to one of these words; the last has the value of a procedure where nothing is behind it."""
        lines = []
        while self.peek() not in ends:
            lines += self.statement(indent)
            if self.peek() not in ends:
                self.take(";", ":")
        return lines or [indent + "pass"]

    def statement(self, indent):
        if self.accept("if"):
            return self.choice(indent, "if")
        if self.accept("return"):
            return [indent + "return " + ("" if self.peek() in (";", "end") else self.expression())]
        if self.accept("error"):
            text = self.expression()
            return [f"{indent}raise Failure({text}, {self.expression() if self.accept(',') else None})"]
        if self.accept("for"):
            name = self.name(self.take())
            self.take("to")
            lines = [f"{indent}for {name} in range(1, {self.expression()} + 1):"]
            self.take("do")
            lines += self.block(indent + " ", "end")
            self.take("end"), self.take("do")
            return lines
        if self.accept("try"):
            lines = [f"{indent}try:"] + self.block(indent + " ", "catch")
            self.take("catch"), self.take(), self.take(":")
            lines += [f"{indent}except Failure as failure:", f"{indent} m_lastexception = failure.told"] + self.block(indent + " ", "end")
            self.take("end"), self.take("try")
            return lines
        if self.accept("read"):
            return [f"{indent}read({self.take()})"]
        kind, name = self.tokens[self.at]
        value = self.expression()
        if not self.accept(":="):
            return [f"{indent}value = {value}"]
        if self.accept("proc"):
            return self.procedure(indent, value)
        if self.declared is not None and name not in self.declared:
            raise SyntaxError(f"{name} is not declared")
        return [f"{indent}{value} = {self.expression()}"]

    def choice(self, indent, word):
        lines = [f"{indent}{word} {self.expression()}:"]
        self.take("then")
        lines += self.block(indent + " ", "elif", "else", "end")
        if self.accept("elif"):
            return lines + self.choice(indent, "elif")
        if self.accept("else"):
            lines += [indent + "else:"] + self.block(indent + " ", "end")
        self.take("end"), self.take("if")
        return lines

    def procedure(self, indent, name):
        self.take("(")
        parameters = []
        while not self.accept(")"):
            parameters.append(self.take())
            self.accept(",")
        self.declared = set(parameters)
        while self.peek() in ("option", "local"):
            is_local = self.take() == "local"
            while not self.accept(";"):
                word = self.take()
                if is_local and word != ",":
                    self.declared.add(word)
        lines = [f"{indent}def {name}({', '.join(self.name(x) for x in parameters)}):", indent + " value = None"]
        lines += self.block(indent + " ", "end") + [indent + " return value"]
        self.take("end"), self.take("proc")
        self.declared = None
        return lines

    def program(self):
        lines = []
        while self.peek():
            lines += self.statement("")
            self.take(";", ":")
        return "\n".join(lines)


class One(list):
    """Counted from 1."""

    def __getitem__(self, at):
        return One(list.__getitem__(self, slice(at.start - 1, at.stop))) if isinstance(at, slice) else list.__getitem__(self, at - 1)

    def __setitem__(self, at, value):
        list.__setitem__(self, at - 1, value)


class Failure(Exception):
    def __init__(self, text, number):
        self.told = One([None, text, number])


class Quit(Exception):
    pass


libm = ctypes.CDLL("libm.so.6")


def of_library(name, count=1):
    function = getattr(libm, name)
    function.restype, function.argtypes = ctypes.c_double, [ctypes.c_double]*count
    return lambda *x: function(*map(float, x))


def power(x, y):
    return x**y if isinstance(x, int) and isinstance(y, int) else of_library("pow", 2)(x, y)


def quotient(x, y):
    if isinstance(x, int) and isinstance(y, int):
        return fractions.Fraction(x, y)
    x, y = float(x), float(y)
    if y == 0:
        return math.nan if x == 0 or math.isnan(x) else math.copysign(math.inf, x)*math.copysign(1, y)
    return x/y


def whole(function):
    """Infinities and NaNs stay."""
    return lambda x: function(x) if not isinstance(x, float) or math.isfinite(x) else x


def vector(count, values=None, datatype=None):
    if datatype == 4:
        values = [ctypes.c_float(x).value for x in values]
    return One(values or [0.0]*count)


def cut(x, y):
    return int(fractions.Fraction(x, y))


def smaller(x, y):
    return of_library("fmin", 2)(x, y)


def larger(x, y):
    return of_library("fmax", 2)(x, y)


MAPLE = {
    "true": True, "false": False, "undefined": math.nan, "infinity": math.inf, "numeric": float, "list": list,
    "Float": float, "evalb": bool, "type": lambda x, kind: isinstance(x, (int, kind)), "abs": abs, "min": smaller, "max": larger,
    "floor": whole(math.floor), "ceil": whole(math.ceil), "trunc": whole(math.trunc),
    "round": whole(lambda x: int(of_library("round")(x))), "ilog2": of_library("logb"), "frem": of_library("remainder", 2),
    "CopySign": of_library("copysign", 2), "NextAfter": of_library("nextafter", 2), "surd": lambda x, n: of_library("cbrt")(x),
    "arctan": lambda *x: of_library("atan2", 2)(*x) if len(x) == 2 else of_library("atan")(*x), "Re": float,
    "GAMMA": of_library("tgamma"), "lnGAMMA": of_library("lgamma"), "log": {2: of_library("log2")}, "ln": of_library("log"),
    "modp": lambda x, y: x % y, "iquo": cut, "irem": lambda x, y: x - y*cut(x, y), "nops": len, "op": list, "float": {4: 4, 8: 8},
    "Bits": types.SimpleNamespace(And=lambda x, y: x & y, Or=lambda x, y: x | y, Xor=lambda x, y: x ^ y),
    "Vector": vector, "Array": lambda what: One(what) if isinstance(what, list) else One([0.0]*what.stop), "table": lambda rows: rows,
    **{name: of_library(name) for name in ("sqrt", "sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log10", "erf", "erfc")},
    **{"arc" + name: of_library("a" + name) for name in ("sin", "cos", "sinh", "cosh", "tanh")},
}


def read(path, names):
    exec(compile(Reader(open(path).read()).program(), path, "exec"), names)


class Runs:
    """The main program, for each list of inputs."""

    def __init__(self, _, base):
        where, name = os.path.split(os.path.abspath(base))
        self.where = where
        self.main = compile(Reader(open(f"{base}_main.mpl").read()).program(), f"{name}_main.mpl", "exec")

    def __call__(self, inputs):
        out, failed = [], []
        names = {"m_" + name: value for name, value in MAPLE.items()}

        def quits(_):
            raise Quit

        def prints(text, *values):
            (failed if text.startswith("guard") else out).append(text.replace("\\n", "\n") % values)

        names.update(One=One, Failure=Failure, power=power, quotient=quotient, m_printf=prints, _quit=quits,
                     read=lambda path: read(os.path.join(self.where, path), names),
                     m_given=One(float(x) for x in inputs))
        try:
            exec(self.main, names)
        except Quit:
            pass
        return types.SimpleNamespace(returncode=1 if failed else 0, stdout="".join(out), stderr="".join(failed))
