"""The families: five kernels on trees of n bodies, see models/families.cpp."""
import json
import math
import pathlib
import shutil

import contenders
import measure

MODELS = pathlib.Path("bench/multibody/models")
PROGRAM = [MODELS / f"{name}.cpp" for name in ("families", "tree", "kinematics", "dynamics")]
ROOT, FLAGS = ["--root", "inputs/dh"], [f"-I{MODELS}", "-Iinputs/dh"]
# title; what the kernel is called with; vectors of n numbers among its inputs
KERNELS = {
    "fk": ("forward kinematics", "double const *, double *", "in, bench_output"),
    "ik": ("inverse kinematics", "double const *, double const *, double *", "in, in + n, bench_output"),
    "rnea": ("inverse dynamics (RNEA)", "double const *, double const *, double const *, double *",
             "in, in + n, in + 2 * n, bench_output"),
    "crba": ("mass matrix (CRBA)", "double const *, double *", "in, bench_output"),
    "aba": ("forward dynamics (ABA)", "double const *, double const *, double const *, double *",
            "in, in + n, in + 2 * n, bench_output"),
}
SHAPES = {"humanoid": [30], "spatial": [1, 2, 4, 8, 16, 32, 64, 128, 256, 1000], "planar": [2, 8, 64], "binary": [7, 63]}
SMALL = {"planar": [2]}
# Up to so many operations generated code is compiled at -O2 and -O3, beyond at -O1; from so many on a member is left out. Outputs
# are all written by one function, which costs the compiler as much as this many operations each.
BOTH, COMPILED, PER_OUTPUT = 20_000, 600_000, 10
SWEPT = [2, 3, 4, 6, 8, 16, 24, 32, 48, 64]


def command_line(kernel, arguments):
    return [*PROGRAM, *ROOT, "--kernel", kernel, "--run-args", " ".join(map(str, [kernel, *arguments]))]


def originals(work):
    """The objects of the library under study, once for each set of flags."""
    jobs, objects = [], {}
    for name, flags in contenders.ORIGINALS.items():
        directory = work / name.replace(" ", "_")
        directory.mkdir(parents=True, exist_ok=True)
        objects[name] = [directory / f"{source.stem}.o" for source in PROGRAM]
        jobs += [(source, target, [*FLAGS, *flags, "-Dmain=example_main"]) for source, target in zip(PROGRAM, objects[name])]
    contenders.compile_all(jobs)
    return objects


def generate(kernel, shape, n, work):
    words = [measure.SYMREAL, "generate", *command_line(kernel, [shape, n]), "-o", work / "kernel.c", "--graph",
             work / "graph", "--json", "--", *FLAGS]
    report = json.loads(measure.command(words))["kernels"][0]
    return report, report["seconds"]


def harness(kernel, shape, n, report, work):
    """The inputs of the measurement, and a program that calls the original with them."""
    with open(work / "graph") as graph:
        inputs = measure.recorded_values("".join(line for line in graph if line.startswith("input ")), "input")
    vectors = ", ".join(measure.initializer(vector) for vector in measure.input_vectors(inputs))
    (work / "data.h").write_text(f"#define BENCH_INPUT_VALUES {{{vectors}}}\n#define BENCH_PARAMETER_VALUES {{0}}\n")
    _, signature, call = KERNELS[kernel]
    (work / "caller.cpp").write_text(
        f'#include "harness.h"\n#include "tree.h"\nvoid {kernel}(tree::Tree const &, {signature});\nint main() {{\n'
        f'  static tree::Tree const tree = tree::make_tree("{shape}", {n});\n  int const n = tree.n;\n  (void)n;\n'
        f"  for (;;) {{\n    double *in = bench_next();\n    {kernel}(tree, {call});\n  }}\n}}\n")
    outputs = sum(entry["count"] for entry in report["outputs"])
    return ["-Ibench", *FLAGS, f"-DBENCH_INPUTS={len(inputs)}", f"-DBENCH_OUTPUTS={outputs}",
            f'-DBENCH_DATA="{work.resolve()}/data.h"', f'-DBENCH_HEADER="{work.resolve()}/kernel.h"']


def burden(report):
    """What the compiler has to do, in operations."""
    return report["operations"]["compute"]["arithmetic"] + PER_OUTPUT * sum(entry["count"] for entry in report["outputs"])


def build(kernel, shape, n, report, objects, work):
    flags = harness(kernel, shape, n, report, work)
    generated = contenders.GENERATED if burden(report) <= BOTH else contenders.LARGE
    compiled = {name: work / f"kernel{flags[0]}.o" for name, flags in generated.items()}
    seconds = contenders.compile_all([(work / "kernel.c", compiled[name], generated[name]) for name in generated])
    contenders.compile_all([("bench/harness.c", work / "harness.o", ["-O2", *flags]),
                            (work / "caller.cpp", work / "caller.o", ["-O2", *flags]),
                            ("bench/generated.c", work / "generated.o", ["-O2", *flags])])
    parts = {**{name: [work / "caller.o", *objects[name]] for name in objects},
             **{name: [work / "generated.o", compiled[name]] for name in generated}}
    executables = {}
    for name, files in parts.items():
        executables[name] = work / name.replace(" ", "_")
        measure.command(["g++", "-o", executables[name], work / "harness.o", *files, "-lm"])
    return executables, {"compile": dict(zip(generated, seconds)),
                         "text": {name: contenders.text_size(compiled[name]) for name in generated}}


def figures(graph):
    """The parallelism of what is computed."""
    analysis = json.loads(measure.command([measure.SYMREAL, "analyze", graph, "--passes=default", "--json"]))
    return {key: analysis[key] for key in ("work", "span", "parallelism", "least_units")}


def member(kernel, shape, n, objects, top, rounds):
    work = top / f"{kernel}_{shape}_{n}"
    work.mkdir(parents=True, exist_ok=True)
    report, seconds = generate(kernel, shape, n, work)
    operations = {stage: measure.counts(report["operations"][stage]) for stage in ("executed", "compute")}
    result = {"kernel": kernel, "shape": shape, "n": n, "operations": operations, "burden": burden(report), "record": seconds["run"],
              "emit": seconds["optimise and emit"]}
    executables, built = build(kernel, shape, n, report, objects, work)
    result.update(figures(work / "graph"), **built, **contenders.check_and_time(executables, rounds))
    shutil.rmtree(work)
    return result


def predicted(results, kernel, shape, n):
    """The compiler's burden of the next member, as a power of n through the two before."""
    known = [(result["n"], result["burden"]) for result in results
             if (result["kernel"], result["shape"]) == (kernel, shape)][-2:]
    if len(known) < 2:
        return 0
    (n0, a), (n1, b) = known
    return b * (n / n1) ** (math.log(b / a) / math.log(n1 / n0))


def measure_families(shapes, top, rounds):
    objects, results = originals(top / "originals"), []
    for shape, sizes in shapes.items():
        for kernel in KERNELS:
            for n in sizes:
                if kernel in ("ik", "crba") and n == 1:
                    continue  # one body neither moves its origin nor changes its inertia about its joint
                if predicted(results, kernel, shape, n) > COMPILED:
                    break
                results.append(member(kernel, shape, n, objects, top, rounds))
                (top / "members.json").write_text(json.dumps(results))
                last = results[-1]
                said = ", ".join(f"{name} {ratio['quickest']:.2f}x" for name, ratio in last["speedup"].items())
                print(f"{kernel} {shape} {n}: {last['operations']['executed']['arithmetic']} operations -> "
                      f"{last['operations']['compute']['arithmetic']}, {last['outputs']} outputs equal; {said}", flush=True)
    return results


def growth(kernel, shape, sizes=SWEPT):
    words = [measure.SYMREAL, "analyze", "--sweep", "N=" + ",".join(map(str, sizes)), "--sweep-argument", "--json",
             *PROGRAM, *ROOT, "--kernel", kernel, "--run-args", f"{kernel} {shape}", "--", *FLAGS]
    return json.loads(measure.command(words))
