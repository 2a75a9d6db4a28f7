"""What structure recovery leaves of textbook code: see bench/recovery/run."""
import argparse
import pathlib
import random
import re
import subprocess
import tempfile
import time

import evaluate

KERNELS = {"inverse dynamics": "rnea", "mass matrix": "crba", "forward dynamics": "aba"}
RX90 = "inverse dynamics of the RX90"
SAMPLES = 20
HEAD = """# Structure recovery

Written by `bench/recovery/run`. Operations are + - * /; sign changes, sines and cosines are not counted. *Executed*: by the
original while it was recorded. The RX90 has its inertial parameters as parameters, and operations on these alone are not
counted. *Error*: the largest over {samples} random inputs against 40 digits, relative to the largest
output, before recovery and after it. The time is that of `symreal opt`, all passes and reading included, and depends on the
machine; the operations do not.

"""


def record(symreal, name, joints, work):
    if name == RX90:
        sources = [f"inputs/dh/{source}.cpp" for source in ("rx90_inverse", "robot", "dynamics")]
        arguments = []
    else:
        sources = [f"inputs/chain/{source}.cpp" for source in (name, "algorithms", "example", "model", "spatial")]
        arguments = ["--run-args", f"{joints} inputs/chain/data/chain-model.csv"]
    subprocess.run([symreal, "generate", *sources, "-o", work / "k.c", "--graph", work / "k.graph", *arguments],
                   check=True, capture_output=True)
    return work / "k.graph"


def optimised(symreal, graph, *options):
    start = time.monotonic()
    text = subprocess.run([symreal, "opt", graph, *options], check=True, capture_output=True, text=True).stdout
    return text, time.monotonic() - start


def error(exact, text, inputs):
    worst = 0
    for values, reference in zip(inputs, exact):
        scale = max(map(abs, reference))
        for value, true in zip(evaluate.in_double(text, values), reference):
            worst = max(worst, float(abs(type(true)(value) - true) / scale))
    return worst


def measure(symreal, name, joints, efforts, work):
    graph = record(symreal, name, joints, work)
    recorded = graph.read_text()
    executed = sum(int(count) for _, count in re.findall(r"^executed (add|sub|mul|div) (\d+)", recorded, re.MULTILINE))
    random.seed(1)
    inputs = [[random.uniform(-2, 2) for _ in range(joints * 3)] for _ in range(SAMPLES)]
    exact = [evaluate.in_forty_digits(recorded, values) for values in inputs]
    finite, _ = optimised(symreal, graph)
    cells = [executed, evaluate.operations(finite)]
    errors = [error(exact, recorded, inputs)]
    for effort in efforts:
        text, seconds = optimised(symreal, graph, "--fp=fast", f"--effort={effort}")
        cells += [evaluate.operations(text), f"{seconds:.1f}"]
        errors.append(error(exact, text, inputs))
    return cells + [f"{each:.1e}" for each in errors]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--symreal", default="build/dev/tool/symreal")
    parser.add_argument("--joints", type=int, nargs="*", default=[6, 16])
    parser.add_argument("--effort", type=int, nargs="*", default=[1, 2, 3])
    parser.add_argument("--only", action="store_true", help="print, and write nothing")
    arguments = parser.parse_args()
    titles = ["", "joints", "executed", "finite"]
    for effort in arguments.effort:
        titles += [f"effort {effort}", "s"]
    titles += ["error before"] + [f"effort {effort}" for effort in arguments.effort]
    rows = ["| " + " | ".join(titles) + " |", "|---" * len(titles) + "|"]
    with tempfile.TemporaryDirectory() as work:
        for joints in arguments.joints:
            for title, name in (KERNELS | ({RX90: RX90} if joints == 6 else {})).items():
                cells = measure(arguments.symreal, name, joints, arguments.effort, pathlib.Path(work))
                rows.append("| " + " | ".join(map(str, [title, joints, *cells])) + " |")
                print(rows[-1], flush=True)
    if not arguments.only:
        results = pathlib.Path(__file__).parent / "results.md"
        results.write_text(HEAD.format(samples=SAMPLES) + "\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
