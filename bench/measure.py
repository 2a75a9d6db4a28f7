"""Original against generated code, side by side: see bench/run.

   generate ──▶ build contenders ──▶ compare their outputs ──▶ time them in turns ──▶ table, plot

Times are ratios of two contenders in the same round, milliseconds apart, so that what else the machine does
touches both. A figure is the median over the rounds, with the interquartile range.
"""
import json
import os
import pathlib
import random
import re
import statistics
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

from hardware import processor
from kernels import KERNELS

SYMREAL = os.environ.get("SYMREAL", "build/dev/tool/symreal")
WORK = pathlib.Path("build/bench")
ROUNDS, BLOCK_SECONDS, VECTORS = 101, 0.001, 16

ORIGINALS = {"original -O2": ["-O2"], "original -O3": ["-O3", "-march=native"]}
GENERATED = {
    "generated -O2": ["-O2", "-ffp-contract=off", "-fno-tree-slp-vectorize"],
    "generated -O3": ["-O3", "-march=native", "-ffp-contract=off", "-fno-tree-slp-vectorize"],
    "generated -O3 fma": ["-O3", "-march=native"],
}
# title: the original, the generated code
RATIOS = {
    "-O2": ("original -O2", "generated -O2"),
    "-O3": ("original -O3", "generated -O3"),
    "-O3 fma": ("original -O3", "generated -O3 fma"),
}


def command(words, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"bench: {' '.join(map(str, words))}\n{done.stderr}")
    return done.stdout


def recorded_values(graph, role):
    """The values of all objects of one role, in order, as the text of the graph has them."""
    lines = re.findall(rf'^{role} "(?:[^"\\]|\\.)*".*$', graph, re.MULTILINE)
    return [float(value) for line in lines for value in line.rsplit(" = ", 1)[1].split()]


def input_vectors(values):
    """The recorded values, and vectors near them, always the same."""
    draw = random.Random(1).uniform
    near = [[value + 0.2 * draw(-1, 1) * max(abs(value), 0.05) for value in values] for _ in range(VECTORS - 1)]
    return [values] + near


def initializer(values):
    return "{" + ", ".join(float(value).hex() for value in values) + "}"


def generate(kernel, work):
    """Generates the code and the file with the input vectors; returns what symreal reports."""
    words = [SYMREAL, "generate", kernel.source, *kernel.others, "-o", work / "kernel.c", "--graph", work / "graph",
             "--json", *kernel.options]
    if kernel.kernel:
        words += ["--kernel", kernel.kernel]
    report = json.loads(command(words + (["--", *kernel.flags] if kernel.flags else [])))["kernels"][0]
    graph = (work / "graph").read_text()
    vectors = ", ".join(initializer(vector) for vector in input_vectors(recorded_values(graph, "input")))
    parameters = initializer(recorded_values(graph, "parameter") or [0])
    (work / "data.h").write_text(f"#define BENCH_INPUT_VALUES {{{vectors}}}\n"
                                 f"#define BENCH_PARAMETER_VALUES {parameters}\n")
    return report


def original_sources(kernel, work):
    """The files that make up the original as a contender, each with the macros that it wants."""
    if kernel.replace:
        lines = pathlib.Path(kernel.source).read_text().splitlines()
        for pragma, text in kernel.replace.items():
            lines = [text if line.strip().startswith(pragma) else line for line in lines]
        caller = work / "region.cpp"
        caller.write_text('#include "harness.h"\n' + "\n".join(lines) + "\n")
        rest = []
    else:
        caller = work / "caller.cpp"
        caller.write_text(f'#include "harness.h"\n{kernel.declare}\nint main() {{\n  {kernel.setup}\n'
                          f"  for (;;) {{\n    double *in = bench_next();\n    {kernel.call}\n  }}\n}}\n")
        rest = [(kernel.source, ["-Dmain=example_main"])]
    return [(caller, []), *rest, *((source, []) for source in kernel.others)]


def build(kernel, work, report):
    """Builds all contenders; returns their names and executables."""
    def slots(role):
        return sum(entry["count"] for entry in report[role])
    macros = [f"-DBENCH_INPUTS={slots('inputs')}", f"-DBENCH_OUTPUTS={slots('outputs')}",
              f'-DBENCH_DATA="{work.resolve()}/data.h"', f'-DBENCH_HEADER="{work.resolve()}/kernel.h"']
    common = ["-w", "-Ibench", "-I" + kernel.directory, *macros, *kernel.flags]

    # The generated code forbids contraction by pragmas.
    text = (work / "kernel.c").read_text()
    (work / "kernel_fma.c").write_text(re.sub(r"^#pragma (?:STDC|GCC) .*\n", "", text, flags=re.MULTILINE))

    jobs, contenders = [], {}
    for name, flags in {**ORIGINALS, **GENERATED}.items():
        sources = original_sources(kernel, work) if name in ORIGINALS else [
            ("bench/generated.c", []), (work / ("kernel_fma.c" if name.endswith("fma") else "kernel.c"), [])]
        objects = []
        for source, own in [("bench/harness.c", []), *sources]:
            target = work / f"{name} {pathlib.Path(source).stem}.o".replace(" ", "_")
            compiler = "gcc" if str(source).endswith(".c") else "g++"
            jobs.append([compiler, "-c", source, "-o", target, *common, *flags, *own])
            objects.append(target)
        contenders[name] = (work / name.replace(" ", "_"), objects)
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(command, jobs))
    for executable, objects in contenders.values():
        command(["g++", "-o", executable, *objects, "-lm"])
    return {name: executable for name, (executable, _) in contenders.items()}


class Contender:
    def __init__(self, *words):
        self.process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(self, request):
        self.process.stdin.write(request + "\n")
        self.process.stdin.flush()
        return self.process.stdout.readline()

    def values(self):
        return [float.fromhex(word) for word in self.ask("v").split()]

    def nanoseconds(self, calls):
        return float(self.ask(f"t {calls}"))

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def worst_difference(values, reference):
    """Relative to the larger of 1 and the reference's magnitude."""
    if len(values) != len(reference):
        sys.exit("bench: two contenders have not the same number of outputs")
    def difference(a, b):
        if a == b or (a != a and b != b):
            return 0
        return abs(a - b) / max(1, abs(b)) if a == a and b == b else float("inf")
    return max(map(difference, values, reference))


def quartiles(values):
    low, middle, high = statistics.quantiles(values, n=4)
    return {"median": middle, "low": low, "high": high}


def measure(kernel):
    work = WORK / kernel.name.replace(" ", "_")
    work.mkdir(parents=True, exist_ok=True)
    report = generate(kernel, work)
    contenders = {name: Contender(executable) for name, executable in build(kernel, work, report).items()}
    try:
        reference = contenders["original -O2"].values()
        difference = max(worst_difference(contender.values(), reference) for contender in contenders.values())
        if not difference < 1e-6:
            sys.exit(f"bench: {kernel.name}: contenders differ by {difference:.1e}")
        calls = {name: max(100, int(BLOCK_SECONDS * 1e9 / contender.nanoseconds(2000)))
                 for name, contender in contenders.items()}
        times = {name: [] for name in contenders}
        for _ in range(ROUNDS):
            for name, contender in contenders.items():
                times[name].append(contender.nanoseconds(calls[name]))
    finally:
        for contender in contenders.values():
            contender.close()
    return {
        "kernel": kernel.name,
        "operations": {stage: counts(report["operations"][stage]) for stage in ("executed", "compute", "preprocess")},
        "nanoseconds": {name: quartiles(values) for name, values in times.items()},
        "ratios": {title: quartiles([a / b for a, b in zip(times[before], times[after])])
                   for title, (before, after) in RATIOS.items()},
        "difference": difference,
    }


def counts(operations):
    """Arithmetic, and everything else that is no sign change: library functions and square roots."""
    arithmetic = operations.get("arithmetic", 0)
    free = {"arithmetic", "add", "sub", "mul", "div", "neg"}
    return {"arithmetic": arithmetic, "calls": sum(n for name, n in operations.items() if name not in free)}


def machine():
    return {"cpu": processor(),
            "compiler": command(["gcc", "--version"]).splitlines()[0], "rounds": ROUNDS,
            "block": f"{BLOCK_SECONDS * 1e3:g} ms"}


def main():
    from present import recorded_ratios, write_plot, write_results  # the picture needs matplotlib; others use the rest

    wanted = sys.argv[1:]
    if wanted == ["--draw"]:
        return write_plot(recorded_ratios())
    unknown = set(wanted) - {kernel.name for kernel in KERNELS}
    if unknown:
        sys.exit(f"bench: no such kernel: {', '.join(sorted(unknown))}")
    results = []
    for kernel in KERNELS:
        if wanted and kernel.name not in wanted:
            continue
        results.append(measure(kernel))
        ratios = ", ".join(f"{title} {ratio['median']:.2f}" for title, ratio in results[-1]["ratios"].items())
        print(f"{kernel.name}: {ratios}", flush=True)
    if not wanted:
        (WORK / "results.json").write_text(json.dumps(results, indent=1))
        write_results(results, machine())


if __name__ == "__main__":
    main()
