#!/usr/bin/env python3
"""generated.py SYMREAL INPUTS [--count N] [--seed K] [-jJ]: changes one thing at random in the C of an example program, and asks
`symreal verify` whether it notices. What it does not notice is tried once more on twenty times as many samples with another seed.
Where these notice nothing either, the same place is changed by much: if that is noticed, the first change changes no value that a
sample comes by (`<` for `<=`, 0 for -0, a last bit that is rounded away); if not, no sample comes there.

The changes: an operator, a comparison, a number (its last bit, its sign, one more), sin for cos, an element of an array beside it,
a variable for another one."""
import argparse
import collections
import concurrent.futures
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "tools"))
from examples_in import EXAMPLES

TOKEN = re.compile(r"""(?P<number>(?<![\w.\]])\d+\.\d+(?:e[-+]?\d+)?)|(?P<element>\b(?:input|constants)\[\d+\])|(?P<function>\b(?:sin|cos)(?=\())
                       |(?P<comparison>(?<= )(?:<=|>=|==|!=|<|>)(?= ))|(?P<operator>(?<=[\w\])])\s?[-+*/]\s?(?=[\w(]))|(?P<variable>\b(?:t\d+|y_\d+)\b)""", re.VERBOSE)
COMPARISONS = {"<": ["<=", ">"], "<=": ["<", ">="], ">": [">=", "<"], ">=": [">", "<="], "==": ["!="], "!=": ["=="]}
OPERATORS = {"+": "-", "-": "+", "*": "/", "/": "*"}
OPPOSITES = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "=="}
CAUGHT, BY_MORE, NOT_MET, NO_CHANGE, BROKEN = "noticed", "noticed on more samples", "no sample comes there", "changes no value", "does not compile"


def changed(kind, text, earlier, random):
    if kind == "number":
        value = float(text)
        return random.choice([repr(math.nextafter(value, math.inf)), f"(-{text})", repr(value + 1)])
    if kind == "element":
        name, index = text[:-1].split("[")
        return f"{name}[{max(0, int(index) + random.choice([-1, 1]))}]"
    if kind == "function":
        return "cos" if text == "sin" else "sin"
    if kind == "comparison":
        return random.choice(COMPARISONS[text])
    if kind == "operator":
        return text.replace(text.strip(), OPERATORS[text.strip()])
    return random.choice(earlier) if earlier else text


def changed_by_much(kind, text):
    if kind == "comparison":
        return OPPOSITES[text]
    if kind == "operator":
        return f"*1.25{text}" if text.strip() in "*/" else text.replace(text.strip(), f"*1.25 {text.strip()} 0.5 +")
    if kind == "variable":  # which may be a truth value
        return f"({text} == 0)"
    return f"1.25*{text}" if kind == "function" else f"(1.25*{text} + 0.5)"


def mutant(code, random):
    """The code with one thing changed in a function's body, the code with the same thing changed by much, and what it is."""
    bodies = [match.span() for match in re.finditer(r"^(?:static )?(?:void|int) \w+\(.*?^}", code, re.MULTILINE | re.DOTALL)]
    tokens = [token for begin, end in bodies for token in TOKEN.finditer(code, code.index("{", begin), end)
              if "(void)" not in code[code.rfind("\n", 0, token.start()):token.start()]]
    declared = {token.end() for token in tokens if token.lastgroup == "variable" and code[token.end():token.end() + 3] == " = "}
    tokens = [token for token in tokens if token.end() not in declared]
    kind = random.choice(sorted({token.lastgroup for token in tokens}))
    token = random.choice([token for token in tokens if token.lastgroup == kind])
    begin = max(begin for begin, _ in bodies if begin <= token.start())
    earlier = sorted(set(re.findall(r"double const (\w+) =", code[begin:token.start()])) - {token.group()})
    text = changed(kind, token.group(), earlier, random)
    line = code.count("\n", 0, token.start()) + 1
    before, after, by_much = code[:token.start()], code[token.end():], changed_by_much(kind, token.group())
    return before + text + after, before + by_much + after, f"line {line}: {token.group().strip()} becomes {text.strip()}", kind


def compiles(file):
    return subprocess.run(["gcc", "-std=c99", "-fsyntax-only", "-w", file], capture_output=True).returncode == 0


class Program:
    def __init__(self, symreal, inputs, name, directory):
        sources, options = EXAMPLES[name]
        before, _, self.flags = options.partition("-- ")
        self.symreal, self.name, self.directory = symreal, name, pathlib.Path(directory)
        self.sources = [str(pathlib.Path(inputs) / source) for source in sources.split()]
        self.before = [word for word in before.split() if not word.startswith("--decisions")]
        path = self.directory / f"{name}.c"
        subprocess.run([symreal, "generate", *self.sources, "-o", path, *before.split(), *(["--", *self.flags.split()] if self.flags else [])],
                       check=True, capture_output=True)
        self.code = path.read_text()

    def notices(self, file, *options):
        words = [self.symreal, "verify", *self.sources, file, *self.before, *options, *(["--", *self.flags.split()] if self.flags else [])]
        done = subprocess.run(words, capture_output=True, text=True)
        if done.returncode not in (0, 3):
            sys.exit(f"{' '.join(map(str, words))}\n{done.stderr}")
        return done.returncode == 3

    def judge(self, number, seed):
        chance = random.Random(f"{seed} {self.name} {number}")
        code, by_much, what, kind = mutant(self.code, chance)
        file = self.directory / f"{self.name}_{number}.c"
        if code == self.code:
            return self.judge(number + 100000, seed)
        file.write_text(code)
        if not compiles(file):
            return BROKEN, kind, what
        if self.notices(file):
            return CAUGHT, kind, what
        more = ["--samples", "20000", "--seed", "77"]
        if self.notices(file, *more):
            return BY_MORE, kind, what
        file.write_text(by_much)
        if not compiles(file):
            sys.exit(f"{self.name}, {what}: the change by much does not compile")
        return (NO_CHANGE if self.notices(file, *more) else NOT_MET), kind, what


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("symreal")
    parser.add_argument("inputs")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", nargs="*", default=list(EXAMPLES))
    parser.add_argument("-j", type=int, default=2)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as directory, concurrent.futures.ThreadPoolExecutor(asked.j) as pool:
        programs = [Program(asked.symreal, asked.inputs, name, directory) for name in asked.only]
        turns = [(programs[k % len(programs)], k // len(programs)) for k in range(asked.count)]
        table = collections.Counter()
        for (program, _), (verdict, kind, what) in zip(turns, pool.map(lambda turn: turn[0].judge(turn[1], asked.seed), turns)):
            table[kind, verdict] += 1
            if verdict not in (CAUGHT, BROKEN):
                print(f"{program.name}, {what}: {verdict}", flush=True)
    verdicts = [CAUGHT, BY_MORE, NOT_MET, NO_CHANGE, BROKEN]
    print(f"\n| | {' | '.join(verdicts)} |\n|---|{'---:|' * len(verdicts)}")
    for kind in sorted({kind for kind, _ in table}):
        print(f"| {kind} | {' | '.join(str(table[kind, verdict]) for verdict in verdicts)} |")
    together = [sum(count for (_, one), count in table.items() if one == verdict) for verdict in verdicts]
    print(f"| together | {' | '.join(map(str, together))} |")


main()
