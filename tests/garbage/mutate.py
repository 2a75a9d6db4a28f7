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
OPTIONS = [["--fp=strict"], ["--fp=fast"], ["--fp=slow"], ["--decisions=guard"], ["--decisions=select"], ["--decisions=explore", "--max-paths=4"],
           ["--decisions=auto", "--max-paths=4"], ["--decisions=explore", "--max-paths=0"], ["--lang=rust"], ["--lang=c,python"], ["--lang=klingon"],
           ["--passes=none"], ["--passes=,,"], ["--prefix=1x"], ["--prefix=a b"], ["--kernel", "f(x=) -> y"], ["--kernel", "f(((("], ["--kernel", ""],
           ["--differentiate", "jacobian(y, x)"], ["--differentiate", "jacobian("], ["--root", "/nowhere"], ["--frozen=allow"], ["--run-args", "'"],
           ["--stats"], ["--json"], ["--mainline"], ["--wrapper"], ["--reroll"], ["--vector=3"], ["--real=float"], ["--config", "none.yaml"],
           ["--joins=off"], ["--tol=-1"], ["--reachable"], ["--snap=2"], ["--effort=9"], ["--type-name=int"], ["--type-name", "a b"], ["--no-such-option"]]
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
