"""One evaluation on two threads, and a batch: see bench/threads/run.

   generate ──▶ blocks --blocks 2 ──▶ C of both blocks ──▶ build ──▶ three ways in turns ──▶ table

The blocks are C made here from the text of the optimised graph: each thread computes its operations in the order of the
graph, and hands over each value that the other needs as soon as it is there. Outputs must be those of the generated code.
"""
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
sys.path.append(str(HERE.parent))
from hardware import processor  # noqa: E402

SYMREAL = pathlib.Path(os.environ["SYMREAL"]).resolve()
WORK = pathlib.Path("build/bench-threads").resolve()
CHAIN = [f"inputs/chain/{name}.cpp" for name in ("algorithms", "example", "model", "spatial")]
# name: what is measured, sources, arguments of generate
KERNELS = {
    "rnea": ("RNEA of 6 joints", ["inputs/chain/rnea.cpp", *CHAIN], []),
    "aba": ("ABA of 64 joints", ["inputs/chain/aba.cpp", *CHAIN], ["--run-args", "64"]),
}
FLAGS = ["-std=gnu11", "-O2", "-ffp-contract=off", "-fno-tree-slp-vectorize", "-fno-builtin-pow", "-pthread"]
INFIX = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
ROUNDS, TURN = 101, 2e6  # nanoseconds of a turn on one thread
CHUNK = 1000  # statements of a function


def command(words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"bench: {' '.join(map(str, words))}\n{done.stdout}{done.stderr}")
    return done.stdout


def spelled(op, operands):
    if op in INFIX:
        return f"{operands[0]} {INFIX[op]} {operands[1]}"
    return f"-{operands[0]}" if op == "neg" else f"{op}({', '.join(operands)})"


def blocks_in_c(graph, block_of):
    """A function a block, in chunks that a compiler takes quickly; what a later chunk needs is in an array."""
    nodes = [(name, op, words.split()) for name, op, words in re.findall(r"^%(\d+) = (\w+) ([^\n]*?)(?: @.*)?$", graph, re.MULTILINE)]
    slot = {name: words[0] for name, op, words in nodes if op == "input"}
    results = re.findall(r"^result (\d+) (%?\S+)", graph, re.MULTILINE)
    users = {}
    for name, op, words in nodes:
        for word in words if op != "input" else []:
            if word[0] == "%":
                users.setdefault(word[1:], set()).add(block_of[name])
    crossing = {name for name in block_of if users.get(name, set()) - {block_of[name]}}
    text = ['#include "crossing.h"', "#include <math.h>",
            *(f"static struct crossing c{name};" for name in sorted(crossing, key=int))]
    for block in (0, 1):
        chunks, chunk, taken = [], [], set()

        def operand(word):
            if word[0] != "%":
                return f"({word})" if "." in word or "e" in word or "0x" in word else f"({word}.0)"
            name = word[1:]
            if name in slot:
                return f"input[{slot[name]}]"
            if block_of[name] != block and name not in taken:
                taken.add(name)
                chunk.append(f"v[{name}] = take(&c{name}, call);")
            return f"v[{name}]"

        for name, op, words in nodes:
            if op == "input" or block_of[name] != block:
                continue
            statement = f"v[{name}] = {spelled(op, [operand(word) for word in words])};"
            chunk.append(statement)
            if name in crossing:
                chunk.append(f"give(&c{name}, v[{name}], call);")
            if len(chunk) >= CHUNK:
                chunks.append(chunk)
                chunk = []
        for number, word in results:
            if block_of.get(word[1:], 0) == block:
                chunk.append(f"output[{number}] = {operand(word)};")
        chunks.append(chunk)
        text.append(f"static double v_{block}[{len(nodes)}];")
        named_in = {}
        for k, lines in enumerate(chunks):
            for name in re.findall(r"v\[(\d+)\]", " ".join(lines)):
                named_in.setdefault(name, set()).add(k)
        for k, lines in enumerate(chunks):
            body = re.sub(r"^v\[(\d+)\] =", lambda at: at[0] if len(named_in[at[1]]) > 1 else f"double const x{at[1]} =",
                          "\n".join(lines), flags=re.MULTILINE)
            body = re.sub(r"v\[(\d+)\]", lambda at: at[0] if len(named_in[at[1]]) > 1 else f"x{at[1]}", body).replace("\n", "\n  ")
            text.append(f"static void block_{block}_{k}(double const *input, double *output, int call) {{\n"
                        f"  double *const v = v_{block};\n  (void)input, (void)output, (void)call, (void)v;\n  {body}\n}}")
        calls = " ".join(f"block_{block}_{k}(input, output, call);" for k in range(len(chunks)))
        text.append(f"void block_{block}(double const *input, double *output, int call) {{ {calls} }}")
    return "\n".join(text) + "\n"


def quartiles(values):
    low, middle, high = statistics.quantiles(values, n=4)
    return middle, low, high, min(values)


def measure(kernel, costs):
    what, sources, arguments = KERNELS[kernel]
    where = WORK / kernel
    shutil.rmtree(where, ignore_errors=True)
    where.mkdir(parents=True)
    graph, csv = where / "optimised.graph", where / "blocks.csv"
    command([SYMREAL, "generate", *sources, *arguments, "--graph", where / "recorded.graph", "-o", where / "kernel.c"])
    command([SYMREAL, "opt", where / "recorded.graph", "--lang=graph", "-o", graph])
    blocks = [SYMREAL, "blocks", graph, "--blocks", "2", "--cost", costs]
    said = json.loads(command([*blocks, "--csv", csv, "--json"]))
    advice = command(blocks)
    text = graph.read_text()
    block_of = dict(line[1:].split(",") for line in csv.read_text().split()[1:])
    block_of = {name: int(block) for name, block in block_of.items()}
    (where / "blocks.c").write_text(blocks_in_c(text, block_of))
    values = " ".join(line.rsplit(" = ", 1)[1] for line in re.findall(r"^input .*$", text, re.MULTILINE)).split()
    outputs = len(re.findall(r"^result ", text, re.MULTILINE))
    (where / "values.h").write_text(f"#define INPUTS {len(values)}\n#define OUTPUTS {outputs}\n#define VALUES {', '.join(values)}\n")
    command(["gcc", *FLAGS, f"-I{HERE}", f"-I{where}", HERE / "driver.c", where / "blocks.c", where / "kernel.c", "-lm", "-o",
             where / "threads"])
    calls = max(2, int(TURN/said["threads"]["one_core"])//2*2)
    rows = [[float(word) for word in line.split()] for line in command([where / "threads", calls, ROUNDS]).splitlines()]
    print(f"{kernel}: measured", file=sys.stderr)
    return what, said, advice, calls, [quartiles(column) for column in zip(*rows)], \
        [quartiles([row[0]/row[k] for row in rows]) for k in (1, 2)]


def shown(nanoseconds):
    return f"{nanoseconds:.0f} ns" if nanoseconds < 1e3 else f"{nanoseconds/1e3:.1f} µs"


def table(what, said, advice, calls, times, gains):
    threads = said["threads"]
    estimates = [shown(threads["one_core"]), f"{shown(threads['by_blocks'])}; about {shown(threads['in_order'])}",
                 shown(threads["one_core"]/2)]
    names = ["one thread", "two blocks on two threads", "a batch on two threads"]
    lines = [f"## {what}", "", f"{said['operations']} operations, {calls} evaluations a turn.", "",
             "| | An evaluation (quartiles) | In the quickest turn | Said to be at least | Times as fast as one thread (quartiles) |",
             "|---|---:|---:|---:|---:|"]
    for k, name in enumerate(names):
        middle, low, high, quickest = times[k]
        gain = "1" if k == 0 else "{:.3g} ({:.3g} to {:.3g})".format(*gains[k-1][:3])
        lines.append(f"| {name} | {shown(middle)} ({shown(low)} to {shown(high)}) | {shown(quickest)} | {estimates[k]} | {gain} |")
    return "\n".join([*lines, "", "```", advice.replace(str(WORK) + "/", "").rstrip(), "```"]) + "\n"


def main():
    kernels = sys.argv[1:] or list(KERNELS)
    if unknown := [kernel for kernel in kernels if kernel not in KERNELS]:
        sys.exit(f"bench: there is no kernel {unknown[0]}; there are {', '.join(KERNELS)}")
    load = f"{os.getloadavg()[0]:.1f}"
    WORK.mkdir(parents=True, exist_ok=True)
    costs = WORK / "costs.json"
    command([SYMREAL, "measure-costs", "-o", costs])
    machine = json.loads(costs.read_text())["threads"]
    barriers = ", ".join(f"{one['nanoseconds']:.0f} ns for {one['threads']} threads" for one in machine["barriers"])
    text = (f"# Threads\n\nWritten by bench/threads/run. {processor()}, {machine['processors']} "
            f"processors on {machine['cores']} cores. A figure is the median of {ROUNDS} turns; "
            f"{load} other processes ran on average when it began, and where they take a processor away, turns are slow. "
            f"`symreal measure-costs` finds: a barrier "
            f"{barriers}; a hand-over {machine['hand_over']:.0f} ns; to wake a thread and wait for its end "
            f"{machine['wake']/1e3:.0f} µs, to start one {machine['start']/1e3:.0f} µs.\n\n")
    text += "\n".join(table(*measure(kernel, costs)) for kernel in kernels)
    print(text)
    if not sys.argv[1:]:
        (HERE / "results.md").write_text(text)


if __name__ == "__main__":
    main()
