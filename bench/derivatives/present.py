"""What was measured, as results.md and results.csv."""
import csv
import pathlib
import sys

import contenders
import makers
from problems import LENGTHS, PROBLEMS

HERE = pathlib.Path(__file__).parent
sys.path.append(str(HERE.parent))
from hardware import processor  # noqa: E402

HEAD = """# Derivatives

Written by `bench/derivatives/run`, on {machine}; [results.csv](results.csv) has the same figures. Each row is a function
and its Jacobian, gradient or Hessian, in one call. Symreal and CppADCodeGen read C++ sources: those of [inputs](../../inputs), and
[models](models) where these are not enough. CasADi and SymForce get the same [formulas](formulas.py) in Python. Pinocchio's analytic
derivatives are written by hand, for the chain alone.

- *operations* are + - * / and squares; signs and functions of the library are not counted.
- *bytes* are those of the compiled object, as `size` has its text: CasADi's has functions of its own besides, Pinocchio's is a library.
- *seconds* are those of recording, differentiating, optimising and writing, without start-up and without compiling what records. They are
  taken while contenders are prepared, on a machine that may be doing other things: they tell orders of magnitude.
- *ns a call* on one thread, the better of gcc 12 and clang 19 at `-O3 -march=native` (from {large} operations on at `-O1`), median of
  turns, with quartiles; *ratio* says how many times as fast the faster of Symreal's two modes is, of medians.

All agree to 1e-9 of the largest number, values apart from derivatives. A generator gets {generate} s of a processor, a compiler 60 s.
"""


def nanoseconds(times):
    low, middle, high = (f"{each:.0f}" if times[1] >= 100 else f"{each:.1f}" for each in times)
    return f"{middle} ({low} to {high})"


def lines_of(problem, row):
    own = min((row[name]["times"][1] for name in makers.NAMES[:2] if "times" in row[name]), default=None)
    for name, made in row.items():
        shown = name.replace("Symreal ", "Symreal `") + "`" if name.startswith("Symreal") else name
        operations = made.get("operations", "")
        seconds = f"{made['generate']:.2f}" if "generate" in made else ""
        if "times" not in made:
            yield [problem.title, shown, operations, "", seconds, made["missing"], ""]
            continue
        ratio = f"{made['times'][1] / own:.2f}" if own else ""
        yield [problem.title, shown, operations, made["bytes"], seconds, nanoseconds(made["times"]), ratio]


def derivatives(table):
    text, title = "", None
    heads = {"jacobian": "Jacobians", "gradient": "Gradient and Hessian", "hessian": "Gradient and Hessian"}
    for problem in PROBLEMS:
        if problem.name not in table:
            continue
        if heads[problem.derivative] != title:
            title = heads[problem.derivative]
            text += f"\n## {title}\n\n| Function | by | operations | bytes | seconds | ns a call | ratio |\n|---|---|---:|---:|---:|---:|---:|\n"
        last = None
        for cells in lines_of(problem, table[problem.name]):
            shown = ["" if cells[0] == last else cells[0], *cells[1:]]
            last = cells[0]
            text += "| " + " | ".join(map(str, shown)) + " |\n"
    return text


def growth(gradients):
    text = ("\n## Cost of a gradient\n\nThe gradient of a weighted sum of all torques by positions, rates and accelerations, "
            "`vjp(tau, [q, qd, qdd])`, of longer and longer\nchains, mode `finite`. The time is that of `symreal opt` from the recorded graph to C, "
            "reading included.\n\n| Joints | Operations of the function | with its gradient | times as many | seconds | milliseconds a joint |\n"
            "|---|---|---|---|---|---|\n")
    for joints, alone, both, seconds in gradients:
        text += f"| {joints} | {alone} | {both} | {both / alone:.2f} | {seconds:.2f} | {1000 * seconds / joints:.1f} |\n"
    return text


def write(table, gradients):
    head = HEAD.format(machine=processor(), large=contenders.LARGE, generate=makers.GENERATE_SECONDS)
    versions = ", ".join(f"{name} {version}" for name, version in contenders.installed().items() if name in makers.PEERS)
    missing = [joints for joints in LENGTHS if f"rnea-{joints}" not in table]
    versions += f". Not measured: chains of {', '.join(map(str, missing))} joints" if missing else ""
    (HERE / "results.md").write_text(f"{head}{versions}.\n{derivatives(table)}{growth(gradients)}")
    with open(HERE / "results.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["row", "derivative", "by", "operations", "bytes", "generating s", "compiler", "ns median", "ns lower quartile",
                         "ns upper quartile", "missing"])
        for problem in PROBLEMS:
            for name, made in table.get(problem.name, {}).items():
                low, middle, high = (f"{each:.4g}" for each in made["times"]) if "times" in made else ("", "", "")
                writer.writerow([problem.name, problem.derivative, name, made.get("operations", ""), made.get("bytes", ""),
                                 f"{made['generate']:.3g}" if "generate" in made else "", made.get("compiler", ""), middle, low, high,
                                 made.get("missing", "")])
