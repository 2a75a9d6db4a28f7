"""Sources, graphs and command lines that somebody has broken: each made by one random generator, so a seed makes it again."""
import re

WORDS = ["input", "output", "parameter", "constant", "scratch", "range", "state", "jacobian", "generate", "call", "decisions", "loop",
         "table", "external", "exact", "function", "return", "[0:3]", "[0:n]", "[:", "[0:-1]", "[0:1e9]", "[0:99999999999]", "(", ")", "{", "}", "[",
         "]", ";", ",", "->", "*", "&", "double", "int", "float", "REAL", "std::vector<double>", "template <", "typename", "auto", "nullptr",
         "0x", "1e999", "'", '"', "R\"(", "#", "##", "\\", "/*", "*/", "//", "__VA_ARGS__", "operator", "goto", "case", "default:", "static",
         "struct", "union", "class", "namespace {", "using", "sizeof", "0", "-1", "18446744073709551616", "if (", "else", "while (1)", "?", ":",
         "asm(", "_Generic(", "[[", "]]", "co_await", "requires", "\0", "\xff", "\ufeff", "\r", "\t", "\f", "%", "$", "@", "`"]
PRAGMAS = ["#pragma symreal", "#pragma symreal function", "#pragma symreal input(", "#pragma symreal function input(x[0:]) output(return)",
           "#pragma symreal function input(x) input(x) output(x)", "#pragma symreal output(y) generate(\"\")", "#pragma symreal generate(\"/\")",
           "#pragma symreal generate(\"a.c\") generate(\"b.c\")", "#pragma symreal loop(0)", "#pragma symreal loop(99999999999)",
           "#pragma symreal decisions(perhaps)", "#pragma symreal range(1, 0)", "#pragma symreal range(nan, 1)", "#pragma symreal call(-1)",
           "#pragma symreal external(main)", "#pragma symreal table(t[0:])", "#pragma symreal state(x)", "#pragma symreal jacobian(y, x)",
           "#pragma symreal function call(4294967296)", "#pragma symreal input(((((((x)))))))", "#pragma symreal \\", "_Pragma(\"symreal input(x)\")",
           "#pragma symreal input(x[0:3][0:3][0:3][0:3][0:3][0:3])", "#pragma STDC FENV_ROUND FE_DOWNWARD", "#include \"missing.h\"",
           "#if 0", "#else", "#endif", "#define double float", "#line 0 \"\"", "#line 2147483648", "#error broken", "#include __FILE__"]
OPTIONS = [["--fp=strict"], ["--fp=fast"], ["--fp=slow"], ["--decisions=guard"], ["--decisions=select"], ["--decisions=explore", "--explore=paths=4"],
           ["--decisions=auto", "--explore=paths=4"], ["--decisions=explore", "--explore=paths=0"], ["--lang=rust"], ["--lang=c,python"], ["--lang=klingon"],
           ["--passes=none"], ["--passes=,,"], ["--prefix=1x"], ["--prefix=a b"], ["--kernel", "f(x=) -> y"], ["--kernel", "f(((("], ["--kernel", ""],
           ["--differentiate", "jacobian(y, x)"], ["--differentiate", "jacobian("], ["--root", "/nowhere"], ["--frozen=allow"], ["--run-args", "'"],
           ["--stats"], ["--json"], ["--mainline"], ["--wrapper"], ["--reroll"], ["--vector=3"], ["--real=float"], ["--config", "none.yaml"],
           ["--explore=joins=off"], ["--tol=-1"], ["--reachable"], ["--snap=2"], ["--effort=9"], ["--type-name=int"], ["--type-name", "a b"], ["--no-such-option"]]
FLAGS = [["-std=c++98"], ["-std=c++99"], ["-std=c89"], ["-I/nowhere"], ["-D="], ["-Ddouble=int"], ["-DMBD_SYMBOLIC"], ["-DREAL=int"], ["-xc"], ["-xfortran"],
         ["-O3", "-ffast-math"], ["-include", "missing.h"], ["-fno-such-flag"], ["-Wall", "-Werror"], ["-c"], ["-o", "elsewhere.o"], ["-E"], ["-M"],
         ["-fsanitize=address"], ["-m32"], ["-target", "nowhere"], ["-"], ["@none"], ["-U__cplusplus"]]


def tokens(text):
    return [match.span() for match in re.finditer(r"\w+|\"[^\"\n]*\"|\S", text)]


def cut(random, text):
    return text[:random.randrange(len(text) + 1)]


def remove(random, text):
    begin = random.randrange(len(text) + 1)
    return text[:begin] + text[begin + random.choice([1, 3, 30, 300]):]


def change_bytes(random, text):
    for _ in range(random.choice([1, 2, 8])):
        at = random.randrange(len(text) + 1)
        text = text[:at] + chr(random.randrange(256)) + text[at + 1:]
    return text


def drop_token(random, text):
    begin, end = random.choice(tokens(text) or [(0, 0)])
    return text[:begin] + text[end:]


def put_token(random, text):
    begin, end = random.choice(tokens(text) or [(0, 0)])
    return text[:begin] + " " + random.choice(WORDS) + " " + text[random.choice([begin, end]):]


def swap_tokens(random, text):
    all_tokens = tokens(text)
    if len(all_tokens) < 2:
        return text
    (a, b), (c, d) = sorted(random.sample(all_tokens, 2))
    return text[:a] + text[c:d] + text[b:c] + text[a:b] + text[d:]


def repeat_span(random, text):
    begin = random.randrange(len(text) + 1)
    end = min(len(text), begin + random.choice([1, 10, 200]))
    return text[:end] + text[begin:end] * random.choice([1, 2, 50]) + text[end:]


def nest(random, text):
    begin, end = random.choice(tokens(text) or [(0, 0)])
    left, right = random.choice(["()", "[]", "{}", ("(-", ")"), ("f(", ")"), ("x[", "]"), ("(double)(", ")"), ("if (1) {", "}")])
    depth = random.choice([3, 100, 400, 3000])
    return text[:begin] + left * depth + text[begin:end] + right * random.choice([depth, depth - 1]) + text[end:]


def swap_lines(random, text):
    lines = text.split("\n")
    i, j = random.randrange(len(lines)), random.randrange(len(lines))
    lines[i], lines[j] = lines[j], lines[i]
    return "\n".join(lines)


def put_pragma(random, text):
    lines = text.split("\n")
    lines.insert(random.randrange(len(lines) + 1), random.choice(PRAGMAS))
    return "\n".join(lines)


def change_pragma(random, text):
    at = [k for k, line in enumerate(text.split("\n")) if "#pragma symreal" in line]
    if not at:
        return put_pragma(random, text)
    lines, k = text.split("\n"), random.choice(at)
    lines[k] = random.choice([drop_token, put_token, swap_tokens, cut, nest, change_bytes, repeat_span])(random, lines[k])
    return "\n".join(lines)


def change_number(random, text):
    numbers = list(re.finditer(r"\b\d+(\.\d*)?\b", text))
    if not numbers:
        return text
    one = random.choice(numbers)
    return text[:one.start()] + random.choice(["0", "-1", "1e308", "2147483648", "99999999999999999999", "0x1p-1074", "08", "1.2.3", "1e", "3'000"]) + text[one.end():]


MUTATIONS = [cut, remove, change_bytes, drop_token, put_token, swap_tokens, repeat_span, nest, swap_lines, put_pragma, change_pragma, change_pragma,
             change_number]


def mutate(random, text):
    for _ in range(random.choice([1, 1, 1, 2, 3])):
        text = random.choice(MUTATIONS)(random, text)
    return text


# What a graph may call things: names that C has, names that it cannot have, and what would end a line, a string or a comment.
NAMES = ["x", "f", "compute", "preprocess", "t1", "v", "input", "sin", "main", "double", "1x", "", "a b", "_Bool", "__x", "NAN", "M_PI", "isnan",
         "unix", "f(void); int g", "*/ int z; /*", "x\\\\", "x\\\"; int z = \\\"", "??/", "%s%n", "\r int z;", "caf\xe9", "table_0", "compute_1", "x[0]",
         "count"]
TYPES = ["int", "unsigned int", "long long", "_Bool"]
NO_TYPES = ["size_t", "int); int z(int", "struct s", ""]
OPERATIONS = [("add", 2), ("sub", 2), ("mul", 2), ("div", 2), ("neg", 1), ("abs", 1), ("sin", 1), ("pow", 2), ("fmin", 2), ("lt", 2), ("eq", 2),
              ("logical_and", 2), ("logical_or", 2), ("logical_not", 1), ("select", 3), ("int32", 1), ("within_int32", 1), ("wrap_uint8", 1),
              ("f32", 1), ("copysign", 2), ("fma", 3), ("int_div", 2)]
# The second of these takes what the first gives; no number does.
INTEGERS = [("wide_int {0}", "wide_value {1}"), ("wide_uint {0}", "wide_less {1} {1}"), ("wide 1 2", "wide_low {1}"), ("wide_int {0}", "neg {1}")]


class HostileGraph:
    """A graph whose lines are well formed; what it means need not be."""

    def __init__(self, random):
        self.random, self.count, self.numbers, self.effect = random, 0, [], "0"
        self.lines = ["symreal-graph 1", f"kernel {self.called('k', 0.1)}", f"input {self.called('x', 0.2)} [3]{self.range()}", 'parameter "p" [2]',
                      f"output {self.called('y', 0.2)} [4]"]
        results = 4
        if self.strange(0.2):
            self.lines.append(f"output {self.quoted()} {{ {self.quoted()} [0] {self.quoted()} }}")
            results += 1
        self.lines.append(f"table 0 {self.quoted()} [3] = 1 2 4")
        self.functions = [self.function(k) for k in range(random.randrange(3))]
        for slot in range(3):
            self.node(f"input {slot}")
        for slot in range(2):
            self.node(f"parameter {slot}")
        for _ in range(random.choice([6, 12, 30])):
            self.operation()
        for slot in range(results):
            self.lines.append(f"result {slot} {self.operand()}")
        if self.strange(0.3):
            self.lines.append(f"guard 0 {self.operand()} {self.quoted()}")
        if self.effect != "0" and not self.strange(0.1):
            self.lines.append("effect " + self.effect)
        if self.strange(0.1):
            self.lines[random.randrange(len(self.lines))] = random.choice(self.lines)

    def strange(self, likely):
        return self.random.random() < likely

    def quoted(self):
        return f'"{self.random.choice(NAMES)}"'

    def called(self, name, strange):
        return self.quoted() if self.strange(strange) else f'"{name}"'

    def range(self):
        return " range " + self.random.choice(["0 1", "1 0", "nan 1", "-inf inf"]) if self.strange(0.1) else ""

    def integer(self):
        return f'integer "{self.random.choice(NO_TYPES if self.strange(0.1) else TYPES)}"'

    def function(self, k):
        """Whether it is pure, and how many arguments it takes."""
        returns = self.random.choice(["returns number ", "returns number ", "returns object 2 ", f"returns {self.integer()} ", ""])
        kinds = ["number"] + [self.random.choice(["number", "number", "input 2", "output 1", "updated 1", "object 2", self.integer()])
                              for _ in range(self.random.randrange(3))]
        is_pure = self.strange(0.5)
        self.lines.append(f"external {k} {self.called(f'f{k}', 0.3)} {'pure ' if is_pure else ''}{returns}takes {' '.join(kinds)}")
        given = sum(0 if kind.startswith("output") else 2 if kind.endswith(" 2") else 1 for kind in kinds)
        return is_pure, given

    def node(self, text):
        is_leaf = text.startswith(("input", "parameter"))
        self.lines.append(f"%{self.count} = {text}" + (" " + self.quoted() if self.strange(0.15) and not is_leaf else ""))
        self.count += 1
        if text.split()[0] not in ("argument", "call", "call_in_order") and not re.match("wide(_u?int)? ", text):
            self.numbers.append(f"%{self.count - 1}")
        return f"%{self.count - 1}"

    def operand(self):
        if self.strange(0.2):
            return self.random.choice(["0", "-0", "1", "2.5", "inf", "nan"])
        return f"%{self.random.randrange(self.count)}" if self.strange(0.02) else self.random.choice(self.numbers[-8:])

    def operation(self):
        kind = self.random.random()
        if kind < 0.05:
            first, second = self.random.choice(INTEGERS)
            integer = self.node(first.format(self.operand()))
            self.node(second.format("", integer))
        elif kind < 0.1:
            self.node(f"lookup 0 {self.operand()}")
        elif kind < 0.25 and self.functions:
            self.call(self.random.randrange(len(self.functions)))
        else:
            name, arity = self.random.choice(OPERATIONS)
            self.node(" ".join([name] + [self.operand() for _ in range(arity)]))

    def call(self, k):
        is_pure, given = self.functions[k]
        arguments = "0"
        for _ in range(given + self.strange(0.05)):
            arguments = self.node(f"argument {arguments} {self.operand()}")
        call = self.node(f"call {arguments} {k}" if is_pure else f"call_in_order {arguments} {k} {self.effect}")
        if not is_pure and not self.strange(0.05):
            self.effect = call
        if not self.strange(0.1):
            self.node(f"returned {call} 0")


def hostile_graph(random):
    return "\n".join(HostileGraph(random).lines) + "\n"
