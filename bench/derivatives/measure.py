"""Jacobians by Symreal and its peers, side by side, and the cost of gradients: see bench/derivatives/run.

   generate ──▶ compile ──▶ compare with differences of the original and with each other ──▶ turns ──▶ tables
"""
import argparse
import json
import pathlib
import re
import statistics
import struct
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "peers"))
import contenders  # noqa: E402
import generate  # noqa: E402
import rows  # noqa: E402
from work import WORK, digest, remembered, run  # noqa: E402

JOINTS, AGREE = 6, 1e-9
KERNELS = {"rnea": ("inverse dynamics", "tau"), "aba": ("forward dynamics", "qdd")}
LENGTHS = [8, 16, 32, 64, 128]
LEVELS = {"gcc": (("gcc", "g++"), ["-O3", "-march=native"]), "clang": (("clang-19", "clang++-19"), ["-O3", "-march=native"])}
HEAD = """# Derivatives

Written by `bench/derivatives/run`, on {machine}. The function and its Jacobian by `q` and `qd`, six joints of
[inputs/chain](../../inputs/chain), textbook formulas. Operations are + - * /; signs, sines and cosines are not counted. CasADi and
Pinocchio are those of [bench/peers](../peers); Pinocchio's derivatives are written by hand. Times are of one call on one thread, the
better of gcc 12 and clang 19 at `-O3 -march=native`, median of turns, with quartiles. All agree to {agree:g} of the largest number.

"""


def sources(kernel):
    return [contenders.CHAIN / f"{name}.cpp" for name in (kernel, "algorithms", "example", "model", "spatial")]


def folder(*names):
    path = WORK / "derivatives" / "-".join(map(str, names))
    path.mkdir(parents=True, exist_ok=True)
    return path


def symreal(kernel, mode):
    tool = pathlib.Path(contenders.SYMREAL).stat()

    def make():
        work, y = folder(kernel, mode), KERNELS[kernel][1]
        options = ["--differentiate", f"jacobian({y}, [q, qd])", "--json", "--run-args", f"{JOINTS} {contenders.model_table()}"]
        said = run([contenders.SYMREAL, "generate", *sources(kernel), "-o", work / "code.c", f"--fp={mode}", *options])[0]
        code = (work / "code.c").read_text().replace('#include "code.h"', (work / "code.h").read_text())
        (work / "contender.c").write_text(generate.MAKE.format(code=code, prepare=(
            "static double constants[constant_count + 1];\n"
            "static void evaluate(double const *x, double *y) { compute(x, constants, y); }\n")))
        return json.loads(said)["kernels"][0]["operations"]["compute"]["arithmetic"], str(work / "contender.c")

    operations, source = remembered(digest("derivatives", kernel, mode, tool.st_mtime_ns, tool.st_size), make)
    flags = contenders.CONTRACTED if mode == "fast" else [*contenders.UNCONTRACTED, "-fno-tree-slp-vectorize"]
    return operations, [source], flags


def casadi(kernel):
    import casadi

    inputs = [casadi.SX.sym(f"x{i}", JOINTS) for i in range(3)]
    y = casadi.vertcat(*generate.outputs(kernel, JOINTS, casadi, map(casadi.vertsplit, inputs)))
    jacobian = casadi.jacobian(y, casadi.vertcat(*inputs[:2]))
    whole = casadi.vertcat(y, casadi.vec(casadi.densify(jacobian.T)))
    function = casadi.Function("code", inputs, [casadi.cse(whole)])
    generator = casadi.CodeGenerator("code.c")
    generator.add(function)
    text = generator.dump()
    arguments = ", ".join(f"x + {i * JOINTS}" for i in range(len(inputs)))
    adapter = (f"static double work[{function.sz_w() + 1}];\nstatic void evaluate(double const *x, double *y) {{\n"
               f"  double const *arguments[{function.sz_arg() + 1}] = {{{arguments}}};\n  double *results[{function.sz_res() + 1}] = {{y}};\n"
               "  casadi_f0(arguments, results, 0, work, 0);\n}\n")
    source = folder(kernel, "casadi") / "contender.c"
    source.write_text(generate.MAKE.format(code=text, prepare=adapter))
    code = re.search(r"^static int casadi_f0\(.*?^}", text, re.MULTILINE | re.DOTALL)[0]
    return generate.operations(code), [source], contenders.CONTRACTED


def pinocchio():
    chain = [contenders.CHAIN / "model.cpp", contenders.CHAIN / "spatial.cpp"]
    return None, [HERE / "pinocchio.cpp", *chain], contenders.PINOCCHIO


def made(kernel):
    """By name: operations, and an object a compiler."""
    table = {"Symreal `finite`": symreal(kernel, "finite"), "Symreal `fast`": symreal(kernel, "fast")}
    if "CasADi" in contenders.installed():
        table["CasADi " + contenders.installed()["CasADi"]] = casadi(kernel)
    if "Pinocchio" in contenders.installed():
        table["Pinocchio " + contenders.installed()["Pinocchio"]] = pinocchio()
    return {name: (operations, {level: contenders.compiled(files, flags, how, 600)["object"] for level, how in LEVELS.items()})
            for name, (operations, files, flags) in table.items()}


def turns(kernel, objects, rounds, seconds):
    vectors = rows.inputs(kernel, JOINTS)
    file = folder(kernel) / "inputs"
    file.write_bytes(b"".join(struct.pack(f"{len(vector)}d", *vector) for vector in vectors))
    return run([WORK / "turns", kernel, JOINTS, contenders.model_table(), file, len(vectors[0]), JOINTS * (1 + 2 * JOINTS), rounds,
                seconds, 1, *objects])[0]


def compare(kernel, table):
    first = None
    for name, (_, objects) in table.items():
        for level, path in objects.items():
            numbers = struct.unpack(f"{16 * JOINTS * (1 + 2 * JOINTS)}d", turns(kernel, [path], 0, 0))
            first = first or numbers
            distance = max(abs(a - b) for a, b in zip(first, numbers)) / max(map(abs, first))
            if not distance < AGREE:
                sys.exit(f"bench: {kernel}: {name}, {level}, is off by {distance:.1e}")


def measured(kernel, table):
    """Nanoseconds a call, of the better compiler."""
    every = [(name, path) for name, (_, objects) in table.items() for path in objects.values()]
    lines = turns(kernel, [path for _, path in every], 41, 12).decode().splitlines()
    columns = zip(*(map(float, line.split()) for line in lines))
    times = {}
    for (name, _), column in zip(every, columns):
        quartiles = statistics.quantiles(column, n=4)
        times[name] = min(times.get(name, quartiles), quartiles, key=lambda each: each[1])
    return times


def jacobians():
    text = "| Jacobian of | by | Operations | ns a call | Symreal `fast` is so many times as fast |\n|---|---|---|---|---|\n"
    for kernel, (title, _) in KERNELS.items():
        table = made(kernel)
        compare(kernel, table)
        times = measured(kernel, table)
        own = times["Symreal `fast`"][1]
        for name, (operations, _) in table.items():
            low, middle, high = times[name]
            text += (f"| {title} | {name} | {operations or ''} | {middle:.0f} ({low:.0f} to {high:.0f}) | {middle / own:.2f} |\n")
    return text


def gradients():
    """The sum of all outputs with weights, by all inputs: what it adds to the function."""
    text = ("\n## Gradients\n\nThe gradient of a weighted sum of all torques by positions, rates and accelerations, `vjp(tau, [q, qd, qdd])`, of "
            "longer and longer\nchains, mode `finite`. The time is that of `symreal opt` from the recorded graph to C, reading included.\n\n"
            "| Joints | Operations of the function | with its gradient | times as many | seconds | milliseconds a joint |\n|---|---|---|---|---|---|\n")
    for joints in LENGTHS:
        work = folder("gradient", joints)
        run([contenders.SYMREAL, "generate", *sources("rnea"), "-o", work / "k.c", "--graph", work / "k.graph", "--run-args",
             f"{joints} {contenders.model_table()}"])
        counts = []
        for options in ([], ["--differentiate", "vjp(tau, [q, qd, qdd])"]):
            begin = time.monotonic()
            said = run([contenders.SYMREAL, "opt", work / "k.graph", "--lang=c", "-o", work / "g.c", "--json", *options])[0]
            seconds = time.monotonic() - begin
            counts.append(json.loads(said)["operations"]["compute"]["arithmetic"])
        text += (f"| {joints} | {counts[0]} | {counts[1]} | {counts[1] / counts[0]:.2f} | {seconds:.2f} | "
                 f"{1000 * seconds / joints:.1f} |\n")
    return text


def main():
    parser = argparse.ArgumentParser(prog="bench/derivatives/run")
    parser.add_argument("--only", action="store_true", help="only to the terminal")
    arguments = parser.parse_args()
    rows.build_turns()
    machine = next(line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name"))
    text = HEAD.format(machine=machine, agree=AGREE) + jacobians() + gradients()
    print(text)
    if not arguments.only:
        (HERE / "results.md").write_text(text)


main()
