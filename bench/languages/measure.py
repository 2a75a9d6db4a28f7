"""Generated code in every language, side by side with generated C: see bench/languages/run.

   generate ──▶ build a driver a language ──▶ compare a sum of outputs ──▶ time them in turns ──▶ table

A driver is a process that reads how often to call, and answers nanoseconds per call and the sum of the first output. It
stands in turn with that of C, so that what else the machine does touches both; a figure is the median of the ratios of
neighbours, with their interquartile range.
"""
import json
import math
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).parent
sys.path.append(str(HERE.parent))
from hardware import processor  # noqa: E402

SYMREAL = pathlib.Path(os.environ["SYMREAL"]).resolve()
WORK = pathlib.Path("build/bench-languages").resolve()
CHAIN = [f"inputs/chain/{name}.cpp" for name in ("algorithms", "example", "model", "spatial")]
# name: what is measured, sources, arguments of generate
KERNELS = {
    "rotation": ("the rotation", ["inputs/rotation/rotation.cpp"], []),
    "rnea": ("RNEA of 6 joints", ["inputs/chain/rnea.cpp", *CHAIN], []),
    "aba": ("ABA of 64 joints", ["inputs/chain/aba.cpp", *CHAIN], ["--run-args", "64"]),
}
EXACT = ["-ffp-contract=off", "-fno-tree-slp-vectorize", "-fno-builtin-pow"]
OCTAVE = ["octave-cli", "--quiet", "--norc", "--no-history"]


# What a contender is called, the language that it takes, its driver, how that is built and run; @BASE@ is the kernel.
CONTENDERS = [
    ("C", "c", "driver.c", [["gcc", "-std=gnu99", "-O2", *EXACT, "driver.c", "@BASE@.c", "-lm", "-o", "c.run"]], ["./c.run"]),
    ("C++", "cpp", "driver.cpp", [["g++", "-std=c++17", "-O2", *EXACT, "driver.cpp", "@BASE@.cpp", "-o", "cpp.run"]], ["./cpp.run"]),
    ("Fortran", "fortran", "driver.f90",
     [["gfortran", "-O2", "-ffp-contract=off", "@BASE@.f90", "driver.f90", "-o", "f90.run"]], ["./f90.run"]),
    ("Rust", "rust", "driver.rs", [["rustc", "--edition", "2021", "-O", "driver.rs", "-o", "rust.run"]], ["./rust.run"]),
    ("Go", "go", "driver.go", [["go", "build", "-o", "go.run", "@BASE@.go", "driver.go"]], ["./go.run"]),
    ("Java", "java", "Driver.java", [["javac", "-d", "classes", "@BASE@.java", "Driver.java"]], ["java", "-cp", "classes", "Driver"]),
    ("JavaScript", "javascript", "driver.mjs", [], ["node", "driver.mjs"]),
    ("Python, one sample", "python", "driver.py", [], ["/usr/bin/python3", "driver.py"]),
    ("Python, a batch", "python", "batch.py", [], ["/usr/bin/python3", "batch.py"]),
    ("MATLAB, in Octave", "matlab", "driver.m", [], [*OCTAVE, "driver.m"]),
    ("MEX, a batch in Octave", "c", "mex.m", [["mkoctfile", "--mex", "@BASE@_mex.c", "@BASE@.c"]], [*OCTAVE, "mex.m"]),
]
EXTENSIONS = {"c": "c", "cpp": "cpp", "fortran": "f90", "rust": "rs", "go": "go", "java": "java", "javascript": "mjs",
              "python": "py", "matlab": "m"}
ROUNDS, BLOCK = 21, 0.02
BATCH = 2000  # samples of a batch


def command(words, where="."):
    """Runs it; the seconds that it took."""
    begin = time.perf_counter()
    environment = dict(os.environ, GO111MODULE="off", GOCACHE=str(WORK / "go-cache"))  # empty at the beginning
    done = subprocess.run([str(word) for word in words], cwd=where, capture_output=True, text=True, env=environment)
    if done.returncode != 0:
        sys.exit(f"bench: {' '.join(map(str, words))}\n{done.stdout}{done.stderr}")
    return time.perf_counter() - begin


class Driver:
    def __init__(self, run, where):
        self.process = subprocess.Popen(run, cwd=where, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def __call__(self, calls):
        """Nanoseconds per call, and the sum."""
        self.process.stdin.write(f"{calls}\n")
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        if not line:
            sys.exit(f"bench: {self.process.args} ended")
        nanoseconds, total = map(float, line.split())
        return nanoseconds, total

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def calls_for(driver, is_batch):
    """How many calls take about a block, when it is warm."""
    calls = BATCH if is_batch else 1
    while True:
        nanoseconds, _ = driver(calls)
        if is_batch or nanoseconds*calls > BLOCK*1e9:
            return calls
        calls = calls*2 if nanoseconds*calls < BLOCK*1e9/4 else math.ceil(BLOCK*1e9/nanoseconds)+calls//10


def warm(driver, calls):
    """A second of calls: compilers at run time need some."""
    end = time.monotonic() + 1
    while time.monotonic() < end:
        driver(calls)


def prepare(kernel, where):
    """Generates everything; the seconds of recording, and of printing each language."""
    _, sources, arguments = KERNELS[kernel]
    shutil.rmtree(where, ignore_errors=True)
    where.mkdir(parents=True)
    graph = where / f"{kernel}.graph"
    recording = command([SYMREAL, "generate", *sources, *arguments, "--graph", graph, "-o", where / "recorded.c"])
    printing = {}
    for language in dict.fromkeys(contender[1] for contender in CONTENDERS):
        extra = ["--mex"] if language == "c" else []
        printing[language] = command([SYMREAL, "opt", graph, f"--lang={language}", "--mainline", *extra, "-o",
                                      where / f"{kernel}.{EXTENSIONS[language]}"])
    text = graph.read_text()
    values = []
    for role in ("input", "parameter"):
        for line in re.findall(rf'^{role} "(?:[^"\\]|\\.)*".*$', text, re.MULTILINE):
            values += line.rsplit(" = ", 1)[1].split()
    (where / "values").write_text("\n".join(repr(float.fromhex(v) if "0x" in v else float(v)) for v in values) + "\n")
    banner = json.loads((where / f"{kernel}.c").read_text().split("\n", 1)[0].split("symreal ", 1)[1])
    places = {"@BASE@": kernel, "@NAMESPACE@": banner["kernel"]}
    places |= {f"@{name.upper()}@": str(banner[name]) for name in ("inputs", "parameters", "constants", "outputs")}
    operations = len(re.findall(r"^%\d+ = (?!input|parameter|constant)\w+ ", text, re.MULTILINE))
    return recording, printing, places, operations


def fill(text, places):
    for name, value in places.items():
        text = text.replace(name, value)
    return text


def measure(kernel):
    where = WORK / kernel
    recording, printing, places, operations = prepare(kernel, where)
    rows, drivers = [], {}
    for name, language, driver, builds, run in CONTENDERS:
        programs = [words[0] for words in builds] + [run[0]]
        if missing := [program for program in programs if not program.startswith("./") and not shutil.which(program)]:
            print(f"{name}: left out, there is no {missing[0]}", file=sys.stderr)
            continue
        (where / driver).write_text(fill((HERE / "drivers" / f"{driver}.in").read_text(), places))
        compiling = sum(command([fill(word, places) for word in build], where) for build in builds) if builds else None
        begin = time.perf_counter()
        drivers[name] = Driver(run, where)
        _, total = drivers[name](1)
        started = time.perf_counter() - begin
        rows.append([name, printing[language], compiling, started, total])
        print(f"{kernel}: {name} is built", file=sys.stderr)
    reference = drivers["C"]
    in_c = calls_for(reference, False)
    results = []
    for name, printed, compiling, started, total in rows:
        driver, is_batch = drivers[name], "batch" in name
        if abs(total - rows[0][4]) > 1e-9*max(1, abs(total)):
            sys.exit(f"bench: {name} gives {total}, C {rows[0][4]}")
        calls = calls_for(driver, is_batch)
        warm(driver, calls)
        times = [(driver(calls)[0], reference(in_c)[0]) for _ in range(ROUNDS)]
        ratios = statistics.quantiles([mine/of_c for mine, of_c in times], n=4)
        results.append((name, printed, compiling, started, statistics.median(mine for mine, _ in times), ratios))
        print(f"{kernel}: {name} {ratios[1]:.2f}", file=sys.stderr)
    for driver in drivers.values():
        driver.close()
    return recording, operations, results


def shown(seconds):
    return "" if seconds is None else f"{seconds:.2f} s"


def table(kernel, recording, operations, results):
    lines = [f"## {KERNELS[kernel][0][0].upper()}{KERNELS[kernel][0][1:]}", "",
             f"{operations} operations recorded, in {recording:.1f} s.", "",
             "| | Optimised and printed | Compiled | Until the first result | A call | Relative to C (quartiles) |", "|---|---:|---:|---:|---:|---:|"]
    for name, printed, compiling, started, nanoseconds, (low, middle, high) in results:
        call = f"{nanoseconds:.0f} ns" if nanoseconds < 1e4 else f"{nanoseconds/1e3:.0f} µs"
        lines.append(f"| {name} | {shown(printed)} | {shown(compiling)} | {shown(started)} | {call} | "
                     f"{middle:.3g} ({low:.3g} to {high:.3g}) |")
    return "\n".join(lines) + "\n"


def main():
    kernels = sys.argv[1:] or list(KERNELS)
    shutil.rmtree(WORK / "go-cache", ignore_errors=True)
    if unknown := [kernel for kernel in kernels if kernel not in KERNELS]:
        sys.exit(f"bench: there is no kernel {unknown[0]}; there are {', '.join(KERNELS)}")
    text = (f"# Languages side by side\n\nWritten by bench/languages/run. {processor()}; "
            f"each language as its compiler optimises by default for speed (-O2, without fused operations). A figure is the "
            f"median of {ROUNDS} turns, of the ratio to C in the same turn; in a batch {BATCH} samples are one call.\n\n")
    text += "\n".join(table(kernel, *measure(kernel)) for kernel in kernels)
    print(text)
    if not sys.argv[1:]:
        (HERE / "results.md").write_text(text)


main()
