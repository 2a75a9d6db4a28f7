#!/usr/bin/env python3
"""pass_rules.py BUILD [--count N] [--seed K] [--tests REGEX] [-jJ]: changes the rules of the passes (engine/optimise/passes/rules.def), one
at a time, and tells what notices: the unit tests, and of what these do not notice, the tests of the tool that REGEX names.

The changes: the row is left out; another letter, number or operation in the replacement; a letter that must stand for one node
twice stands for two; an earlier mode; no condition. Nothing of the build is changed: only rule.cpp is compiled anew, and linked
before the library. docs/trust/mutation.md has the results."""
import argparse
import collections
import concurrent.futures
import json
import pathlib
import random
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

ROW = re.compile(r'^RULE\((?P<topic>\w+), (?P<mode>\w+), "(?P<pattern>[^"]*)", "(?P<replacement>[^"]*)", (?P<condition>\w+), (?P<rest>".*"\))$')
EARLIER = {"finite": "strict", "fast": "finite"}
OTHERS = {"add": "sub", "sub": "add", "mul": "div", "div": "mul", "neg": "abs", "abs": "neg", "sqrt": "abs", "lt": "gt", "select": "fma"}
ROOT = pathlib.Path(__file__).resolve().parents[2]


def spelled(row, **changes):
    row = {**row, **changes}
    return 'RULE({topic}, {mode}, "{pattern}", "{replacement}", {condition}, {rest}'.format(**row)


def letters(term):
    return re.findall(r"\b[a-z]\b", term)


def replaced(term, match, text):
    return term[:match.start()] + text + term[match.end():]


def mutants(row, chance):
    """What the row becomes, by the kind of change. Whatever gives the row itself is left out."""
    yield "left out", ""
    if row["mode"] in EARLIER:
        yield "an earlier mode", spelled(row, mode=EARLIER[row["mode"]])
    if row["condition"] != "always":
        yield "no condition", spelled(row, condition="always")
    pattern, replacement = row["pattern"], row["replacement"]
    tokens = list(re.finditer(r"-?\b[\d.]+\b|\b[a-z]\b|(?<=\()\w+", replacement))
    token = chance.choice(tokens)
    text = token.group()
    if text in OTHERS:
        yield "replacement", spelled(row, replacement=replaced(replacement, token, OTHERS[text]))
    elif len(text) == 1 and text.isalpha():
        other = sorted(set(letters(pattern)) - {text}) or [f"(neg {text})"]
        yield "replacement", spelled(row, replacement=replaced(replacement, token, chance.choice(other)))
    elif re.fullmatch(r"-?[\d.]+", text):
        yield "replacement", spelled(row, replacement=replaced(replacement, token, str(1 - float(text))))
    twice = [name for name, count in collections.Counter(letters(pattern)).items() if count > 1]
    if twice:
        last = list(re.finditer(rf"\b{twice[0]}\b", pattern))[-1]
        free = next(name for name in "yzwvu" if name not in letters(pattern))
        yield "two nodes", spelled(row, pattern=replaced(pattern, last, free))


class Build:
    def __init__(self, directory):
        self.directory = directory
        commands = json.loads((directory / "compile_commands.json").read_text())
        compile_rule = next(one["command"] for one in commands if one["file"].endswith("engine/optimise/passes/rule.cpp"))
        self.compile = shlex.split(compile_rule.split(" -o ")[0])
        if "ccache" in self.compile[0]:
            self.compile.pop(0)
        self.links = {target: self.link(target) for target in ("tests/symreal_runtime_unit_tests", "tool/symreal")}

    def link(self, target):
        lines = subprocess.run(["ninja", "-C", self.directory, "-t", "commands", target], check=True, capture_output=True, text=True)
        words = lines.stdout.strip().splitlines()[-1].split("&&")
        return shlex.split(next(word for word in words if f" -o {target}" in word))

    def make(self, target, work):
        """The target with the rule.cpp of `work`."""
        command = [word for word in self.links[target] if not word.endswith("/passes/rule.cpp.o")]
        place = command.index("-o")
        command[place:place + 2] = [work / "rule.o", "-o", work / pathlib.Path(target).name]
        subprocess.run(command, cwd=self.directory, check=True)

    def judge(self, text, pattern):
        with tempfile.TemporaryDirectory() as name:
            work = pathlib.Path(name)
            (work / "engine/optimise/passes").mkdir(parents=True)
            (work / "engine/optimise/passes/rules.def").write_text(text)
            compiler, *options = self.compile
            done = subprocess.run([compiler, f"-I{work}", *options, "-o", work / "rule.o", "-c", ROOT / "engine/optimise/passes/rule.cpp"],
                                  cwd=self.directory, capture_output=True, text=True)
            if done.returncode != 0:
                return "does not compile"
            self.make("tests/symreal_runtime_unit_tests", work)
            about_rules = "*Rule*:*Promise*"
            failed = self.ask_units(work, about_rules) or (self.ask_tool(work, pattern) if pattern else "")
            return failed or self.ask_units(work, f"-{about_rules}")

    def ask_units(self, work, names):
        try:
            done = subprocess.run([work / "symreal_runtime_unit_tests", "--gtest_brief=1", "--gtest_fail_fast", f"--gtest_filter={names}"],
                                  cwd=self.directory / "tests", capture_output=True, text=True, timeout=600)
        except subprocess.TimeoutExpired:
            return "unit tests: no end"
        failed = re.search(r"\[  FAILED  \] (\S+?)[,\s]", done.stdout)
        return "" if done.returncode == 0 else f"unit tests: {failed.group(1) if failed else f'status {done.returncode}'}"

    def ask_tool(self, work, pattern):
        """In a build directory whose other parts are those of the build."""
        build = work / "build"
        for place, without in (("", {"tool", "tests"}), ("tool", {"symreal"}), ("tests", {"lit.site.cfg.py", "Output", "cache"})):
            (build / place).mkdir()
            for entry in (self.directory / place).iterdir():
                if entry.name not in without:
                    (build / place / entry.name).symlink_to(entry)
        site = (self.directory / "tests" / "lit.site.cfg.py").read_text()
        (build / "tests" / "lit.site.cfg.py").write_text(site.replace(str(self.directory), str(build)))
        self.make("tool/symreal", work)
        shutil.move(work / "symreal", build / "tool" / "symreal")
        done = subprocess.run([sys.executable, "/usr/lib/llvm-19/build/utils/lit/lit.py", "-s", "-j1", "--max-failures=1",
                               f"--filter={pattern}", build / "tests"], capture_output=True, text=True)
        if "Passed" not in done.stdout and "Failed" not in done.stdout:
            sys.exit(f"no test is called {pattern}\n{done.stdout}{done.stderr}")
        failed = re.search(r"^ +symreal :: (\S+)", done.stdout, re.MULTILINE)
        return failed.group(1) if failed else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--count", type=int, default=0, help="so many, drawn from all; by default all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tests", default="passes/", help="tests of the tool that are asked as well")
    parser.add_argument("-j", type=int, default=1)
    asked = parser.parse_args()
    table = (ROOT / "engine/optimise/passes/rules.def").read_text().splitlines()
    chance = random.Random(asked.seed)
    turns = []
    for number, line in enumerate(table):
        if row := ROW.match(line):
            turns += [(number, kind, new) for kind, new in mutants(row.groupdict(), chance) if new != line]
    if asked.count:
        turns = sorted(chance.sample(turns, asked.count))
    build, counts = Build(asked.build), collections.Counter()

    def judge(turn):
        number, _, new = turn
        return build.judge("\n".join([*table[:number], new, *table[number + 1:]]) + "\n", asked.tests)

    with concurrent.futures.ThreadPoolExecutor(asked.j) as pool:
        for (number, kind, new), verdict in zip(turns, pool.map(judge, turns)):
            counts[kind, verdict.split(":")[0] if verdict.startswith("unit") else "tool" if verdict else "nothing"] += 1
            print(f"{table[number]}\n  {kind}: {new or '-'}\n  {verdict or 'NOT NOTICED'}", flush=True)
    for (kind, verdict), count in sorted(counts.items()):
        print(f"{kind}, {verdict}: {count}")
    missed = sum(count for (_, verdict), count in counts.items() if verdict == "nothing")
    print(f"{sum(counts.values())} changes, {missed} not noticed")


main()
