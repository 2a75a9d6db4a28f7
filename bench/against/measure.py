"""See bench/against/run."""
import argparse
import array
import ctypes
import json
import pathlib
import random
import re
import statistics
import subprocess
import sys
import tempfile

PEERS = pathlib.Path(__file__).resolve().parent.parent / "peers"
COMPILERS = ("gcc", "clang-19")
VECTORS = 16  # bench/peers/turns.c
TRIES, ROUNDS, SECONDS = 20000, 61, 60
TOLERANCE = 1e-6  # of the largest value of an output: the original is compiled with fused operations, and mode fast rounds in other places

ADAPTER = """#include "{header}"
#include "contender.h"
static double const parameters[] = {{{parameters}}};
static double constants[{constants} + 1];
static void evaluate(double const *input, double *output) {{ {prefix}compute(input, constants, output); }}
Evaluate contender(char const *kernel, int joints, char const *model) {{
  (void)kernel, (void)joints, (void)model;
  {prefix}preprocess(parameters, constants);
  return evaluate;
}}
"""


def command(words):
    done = subprocess.run([str(word) for word in words], capture_output=True)
    if done.returncode != 0:
        sys.exit(f"bench: {' '.join(map(str, words))}\n{done.stdout.decode()}{done.stderr.decode()}")
    return done.stdout


class Generated:
    def __init__(self, path, parameters, work):
        self.path = pathlib.Path(path).resolve()
        header = self.path.with_suffix(".h")
        self.facts = json.loads(re.search(r"/\* symreal (\{.*\})", header.read_text())[1])
        self.objects = {}
        if len(parameters) != self.facts.get("parameters", 0):
            sys.exit(f"bench: {path} has {self.facts.get('parameters', 0)} parameters: name their values with --parameters")
        adapter = work / f"{self.path.stem}-adapter.c"
        adapter.write_text(ADAPTER.format(header=header, prefix=self.facts["prefix"], constants=self.facts.get("constants", 0),
                                          parameters=", ".join(map(repr, parameters)) or "0"))
        contract = "fast" if self.facts["mode"] == "fast" else "off"
        for compiler in COMPILERS:
            self.objects[compiler] = work / f"{self.path.stem}-{compiler}.so"
            flags = ["-O3", "-march=native", f"-ffp-contract={contract}", "-fno-builtin-pow", "-fPIC", "-shared", "-w", "-I", PEERS]
            flags += ["-fno-tree-slp-vectorize"] if compiler == "gcc" else []
            command([compiler, *flags, adapter, self.path, "-lm", "-o", self.objects[compiler]])

        library = ctypes.CDLL(str(self.objects["gcc"]))
        self.compute = getattr(library, self.facts["prefix"] + "compute")
        self.constants = doubles([0.0] * self.facts.get("constants", 0))
        getattr(library, self.facts["prefix"] + "preprocess")(doubles(parameters), self.constants)

    def computes(self, vector):
        """Whether the guards hold."""
        outputs = doubles([0.0] * self.facts["outputs"])
        return not self.facts.get("guards") or self.compute(doubles(vector), self.constants, outputs) == 0


def doubles(values):
    return (ctypes.c_double * len(values))(*values)


def draw(kernels, ranges):
    count = kernels[0].facts["inputs"]
    if len(ranges) not in (1, count):
        sys.exit(f"bench: there are {count} inputs: name one range for all, or one for each")
    ranges = ranges * count if len(ranges) == 1 else ranges
    chance, vectors = random.Random(1), []
    for _ in range(TRIES):
        vector = [chance.uniform(low, high) for low, high in ranges]
        if all(kernel.computes(vector) for kernel in kernels):
            vectors.append(vector)
        if len(vectors) == VECTORS:
            return vectors
    sys.exit(f"bench: of {TRIES} inputs only {len(vectors)} satisfy all guards")


def time(value):
    return f"{value:.3g} ns" if value < 1000 else f"{value / 1000:.3g} µs"


def gain(original, other):
    low, middle, high = statistics.quantiles([a / b for a, b in zip(original, other)], n=4)
    return f"{middle:.2f} ({low:.2f}-{high:.2f})"


def numbers(text):
    return [float(word) for word in text.split(",")]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("original")
    parser.add_argument("generated", nargs="+")
    parser.add_argument("--range", action="append", required=True)
    parser.add_argument("--parameters", default="")
    parser.add_argument("--name", default="")
    given = parser.parse_args()
    parameters = numbers(given.parameters) if given.parameters else []
    with tempfile.TemporaryDirectory(prefix="bench-against-") as name:
        work = pathlib.Path(name)
        kernels = [Generated(path, parameters, work) for path in given.generated]
        (work / "vectors").write_bytes(array.array("d", sum(draw(kernels, list(map(numbers, given.range))), [])))
        turns = work / "turns"
        command(["cc", "-O2", "-I", PEERS, PEERS / "turns.c", "-ldl", "-o", turns])
        objects = [pathlib.Path(given.original).resolve()] + [kernel.objects[one] for kernel in kernels for one in COMPILERS]
        facts = kernels[0].facts

        def run(rounds):
            return command([turns, "-", 0, "-", work / "vectors", facts["inputs"], facts["outputs"], rounds, SECONDS, 1, *objects])

        values = array.array("d", run(0))
        outputs = facts["outputs"]
        originals = values[:VECTORS * outputs]
        for k in range(len(originals), len(values)):
            wanted, largest = originals[k % len(originals)], max(map(abs, originals[k % outputs::outputs]))
            if not abs(values[k] - wanted) <= TOLERANCE * largest:
                sys.exit(f"bench: output {k % outputs} of {objects[k // len(originals)].name} is {values[k]}, of the original {wanted}")
        times = list(zip(*[map(float, line.split()) for line in run(ROUNDS).decode().splitlines()]))
    ways = [f"{kernel.path.stem}, {one}" for kernel in kernels for one in COMPILERS]
    cells = [gain(times[0], other) for other in times[1:]]
    print(f"| Kernel | Original | {' | '.join(ways)} |\n|---|---:|{'---:|' * len(ways)}")
    print(f"| {given.name or facts['kernel']} | {time(statistics.median(times[0]))} | {' | '.join(cells)} |")


if __name__ == "__main__":
    main()
