#!/usr/bin/env python3
"""Breaks sources, graphs and command lines, and runs symreal on them:
run.py --symreal TOOL --count N [--graphs] [--seed S] [--jobs J] [--keep DIR] [--only K]

Each must end with status 0 and what was asked for, or with a diagnostic and nothing written: no crash, no internal error, no
time-out, no half-written file, no directory left behind. The numbers K of mutants at fault are printed; --only K makes one again, and
--keep DIR leaves its files there.
"""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from mutate import FLAGS, OPTIONS, hostile_graph, mutate  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
SECONDS, MEMORY = 90, 3 << 30
# A broken program still runs: none that could do harm.
HARMFUL = re.compile(r"\b(system|remove|unlink|rename|kill|fork|exec\w*|popen|rmdir|truncate|fopen|freopen|open|creat|ofstream|filesystem)\b")
INTERNAL = re.compile(r"internal error|internal check|Assertion|terminate called|PLEASE submit|Stack dump|LLVM ERROR|UNREACHABLE|Sanitizer")
DIAGNOSTIC = re.compile(r"^(.*?)(symreal: |:\d+: |: )?error: .*\[SYM\d{3}\]", re.MULTILINE)


def seeds():
    """Programs of one file."""
    found = []
    for folder in ("inputs/*", "tests/tool", "tests/explore", "tests/bad_input", "tests/pitfalls", "tests/c", "tests/structures", "tests/macros", "tests/rewrite"):
        for path in sorted(ROOT.glob(folder + "/*.c*")):
            text = path.read_text(encoding="latin-1")
            if path.suffix in (".c", ".cpp") and "pragma symreal" in text and not HARMFUL.search(text) and not re.search(r'#include "', text):
                found.append((path.name, re.sub(r"(?m)^.*(RUN|CHECK|[A-Z]+(-NEXT|-NOT)?):.*\n", "", text)))
    return found


def memory_of(group):
    """Of the processes of the group, in bytes."""
    pages = 0
    for process in os.listdir("/proc"):
        if process.isdigit():
            try:
                if os.getpgid(int(process)) == group:
                    pages += int(pathlib.Path("/proc", process, "statm").read_text().split()[1])
            except (OSError, IndexError, ValueError):
                pass
    return pages * resource.getpagesize()


def run(command, directory, environment):
    """Status, output, and what was wrong with the way it ended."""
    def limits():
        resource.setrlimit(resource.RLIMIT_FSIZE, (256 << 20, 256 << 20))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    process = subprocess.Popen(command, cwd=directory, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               start_new_session=True, preexec_fn=limits)
    output, begin, wrong = [], time.monotonic(), None
    reader = threading.Thread(target=lambda: output.append(process.stdout.read()))
    reader.start()
    while wrong is None and process.poll() is None:
        time.sleep(0.05)
        if time.monotonic() - begin > SECONDS:
            wrong = f"did not end within {SECONDS} s"
        elif memory_of(process.pid) > MEMORY:
            wrong = f"took more than {MEMORY >> 30} GiB"
    if wrong:
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    reader.join()
    return process.returncode, b"".join(output).decode("utf-8", "replace"), wrong


class Mutant:
    def __init__(self, symreal, seed, number, programs, graphs):
        self.symreal, self.number, self.graphs, self.random = symreal, number, graphs, random.Random(f"{seed} {number}")
        self.name, self.text = self.random.choice(programs)

    def test(self, directory):
        """What kind it was, how it ended, and what is wrong, or None."""
        work, self.temporary = directory / "work", directory / "temporary"
        work.mkdir()
        self.temporary.mkdir()
        self.environment = dict(os.environ, TMPDIR=str(self.temporary), XDG_CACHE_HOME=str(directory / "cache"))
        kind = self.random.choice(["generate"] * 6 + ["scan", "rewrite", "opt", "opt", "verify"]) if not self.graphs else "graph"
        if kind == "graph":
            return kind, *self.of_hostile_graph(work)
        if kind in ("opt", "verify"):
            return kind, *self.of_generated(kind, work)
        is_whole = self.random.random() < 0.2  # the command line alone is broken
        self.write(work / self.name, self.text if is_whole else mutate(self.random, self.text))
        command = [str(self.symreal), kind, self.name]
        if kind == "generate":
            command += ["-o", "out.c", "--timeout=5"] + (self.random.choice(OPTIONS) if is_whole or self.random.random() < 0.5 else [])
        elif kind == "rewrite":
            command += self.random.choice([["--diff"], ["--out-root", "mirror"], ["--in-place"]])
        if self.random.random() < 0.25:
            command += ["--"] + self.random.choice(FLAGS)
        return kind, *self.judge(command, work)

    def of_hostile_graph(self, work):
        """A graph that is well formed: what is taken gives code that compiles."""
        self.write(work / "hostile.graph", hostile_graph(self.random))
        language = self.random.choice(["c"] * 6 + ["cpp", "python", "graph"])
        command = [str(self.symreal), "opt", "hostile.graph", "-o", "out." + {"python": "py"}.get(language, language), "--lang=" + language]
        command += self.random.choice([[], [], ["--fp=fast", "--effort=1"], ["--passes=none"], ["--passes=none", "--fp=strict"], ["--vector=2"], ["--mainline"]])
        return self.judge(command, work)

    def of_generated(self, kind, work):
        """What reads the files that symreal writes."""
        self.write(work / self.name, self.text)
        status, output, wrong = run([str(self.symreal), "generate", self.name, "-o", "seed.c", "--graph", "seed.graph", "--decisions=guard", "--frozen=allow"],
                                    work, self.environment)
        if wrong or status != 0 or (work / "seed.c").is_dir():
            return "no seed", wrong or (f"ended with status {status}" if status not in (0, 1) else None)
        text = (work / ("seed.graph" if kind == "opt" else "seed.c")).read_text(encoding="latin-1")
        if kind == "opt":
            self.write(work / "broken.graph", mutate(self.random, text))
            command = [str(self.symreal), "opt", "broken.graph", "-o", "out.c", "--lang=" + self.random.choice(["c", "graph", "schedule", "rust", "python"])]
            command += self.random.choice([[], ["--fp=fast"], ["--reroll"], ["--vector=4"], ["--passes=none"]])
        else:
            self.write(work / "seed.c", mutate(self.random, text))
            command = [str(self.symreal), "verify", self.name, "seed.c", "--samples=20", "--min-samples=1", "--timeout=5"]
        return self.judge(command, work, is_run=kind == "verify")

    def write(self, path, text):
        path.write_bytes(text.encode("latin-1", "replace"))

    def judge(self, command, work, is_run=False):
        before = {path: path.read_bytes() for path in work.rglob("*") if path.is_file()}
        status, output, wrong = run(command, work, self.environment)
        self.command, self.output = command, output
        ended = f"status {status}"
        if wrong:
            return ended, wrong
        if status < 0 or status > 4:
            return ended, f"ended with status {status}"
        if found := INTERNAL.search(output):
            return ended, found.group()
        if status == 1 and not DIAGNOSTIC.search(output):
            return ended, "failed without a diagnostic"
        if left := [path.name for path in self.temporary.iterdir()]:
            return ended, f"left {left[0]} behind"
        new = [path for path in work.rglob("*") if path.is_file() and path.read_bytes() != before.get(path)]
        if status == 1 and new:
            return ended, f"failed and has written {new[0].name}"
        if fault := self.compile(command, work):
            return ended, fault
        return ended, None


    def compile(self, command, work):
        """Why code does not compile."""
        if any("float" in word for word in command) or command[1] not in ("generate", "opt"):
            return None
        compilers = {"out.c": ["gcc", "-std=c99"], "out.cpp": ["g++", "-std=c++17"], "out.py": [sys.executable, "-m", "py_compile"]}
        for name, compiler in compilers.items():
            path = work / name
            if not path.exists() or (name == "out.c" and any("--lang" in word and word != "--lang=c" for word in command)):
                continue
            files = list(path.glob("*" + path.suffix)) or [path]  # several kernels stand in a directory
            flags = [] if name == "out.py" else ["-fsyntax-only", "-w"]
            compiled = subprocess.run([*compiler, *flags, *files], cwd=work, capture_output=True, text=True)
            if compiled.returncode != 0:
                return "generated code does not compile: " + compiled.stderr.strip().split("\n")[0]
        return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--symreal", type=pathlib.Path, required=True)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--graphs", action="store_true", help="graphs alone, each well formed, of any meaning")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--only", type=int)
    options = parser.parse_args()
    options.symreal = options.symreal.resolve()
    programs = seeds()
    numbers = [options.only] if options.only is not None else range(options.count)

    def one(number):
        mutant = Mutant(options.symreal, options.seed, number, programs, options.graphs)
        with tempfile.TemporaryDirectory(prefix="garbage-") as directory:
            kind, ended, wrong = mutant.test(pathlib.Path(directory))
            if options.keep and (wrong or options.only is not None):
                shutil.copytree(pathlib.Path(directory, "work"), options.keep / str(number), dirs_exist_ok=True)
                (options.keep / f"{number}.txt").write_text(" ".join(map(repr, getattr(mutant, "command", []))) + "\n" + getattr(mutant, "output", ""))
        return number, kind, ended, wrong

    counts, faults = collections.Counter(), 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for number, kind, ended, wrong in pool.map(one, numbers):
            counts[kind, ended] += 1
            if wrong:
                faults += 1
                print(f"mutant {number}, {kind}: {wrong}", flush=True)
    for (kind, ended), count in sorted(counts.items()):
        print(f"{kind:<10}{ended:<12}{count:>6}")
    print(f"{sum(counts.values())} mutants of {len(programs)} programs, {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
