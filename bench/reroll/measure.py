"""--reroll in modes finite and fast, straight-line code and the original: see bench/reroll/run.

   generate ──▶ verify the loops ──▶ compile ──▶ turns of each, one after the other ──▶ table

A chain longer than the model of inputs/chain repeats its first 63 links; `rnea*` has other numbers in every link.
"""
import os
import pathlib
import random
import re
import shutil
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
sys.path.append(str(HERE.parent))
from hardware import processor  # noqa: E402

SYMREAL = pathlib.Path(os.environ["SYMREAL"]).resolve()
WORK = pathlib.Path("build/bench-reroll").resolve()
CHAIN = [f"inputs/chain/{name}.cpp" for name in ("algorithms", "example", "model", "spatial")]
MODEL = pathlib.Path("inputs/chain/data/chain-model.csv")
SIZES, OTHER_SIZES = (16, 64, 256, 1000), {"rnea*": (1000,), "covariance": (16, 32, 64)}
# name: what is measured, its number in driver.cpp, sources
KERNELS = {
    "fk": ("forward kinematics of N links", 0, ["inputs/chain/fk.cpp", *CHAIN]),
    "rnea": ("inverse dynamics (RNEA) of N links", 1, ["inputs/chain/rnea.cpp", *CHAIN]),
    "rnea*": ("the same, other numbers in every link", 1, ["inputs/chain/rnea.cpp", *CHAIN]),
    "aba": ("forward dynamics (ABA) of N links", 2, ["inputs/chain/aba.cpp", *CHAIN]),
    "crba": ("mass matrix (CRBA) of N links", 3, ["inputs/chain/crba.cpp", *CHAIN]),
    "series": ("a series of N terms", 4, [HERE / "programs/series.cpp"]),
    "swing": ("N steps of Runge and Kutta, a pendulum", 5, [HERE / "programs/swing.cpp"]),
    "top": ("N steps of Runge and Kutta, a spinning top", 8, [HERE / "programs/top.cpp"]),
    "filter": ("N samples of a filter", 6, [HERE / "programs/filter.cpp"]),
    "covariance": ("the covariance of N states one step on", 7, [HERE / "programs/covariance.cpp"]),
}
FLAGS = ["-O3", "-march=native", "-w"]
KEPT = ["-ffp-contract=off", "-fno-tree-slp-vectorize"]  # what generated code asks for; it says so itself, too
LOAD = os.getloadavg()[0]
WAYS = {"straight": [], "reroll": ["--reroll"], "fast": ["--reroll", "--fp=fast"]}
MOST_SECONDS, MOST_MEGABYTES = 120, 50  # for the compiler, of straight-line code; longer code takes all memory


def command(words, limit=None):
    """What it says; nothing if it takes too long."""
    try:
        done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return None
    if done.returncode != 0:
        sys.exit(f"bench: {' '.join(map(str, words))}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def write_model(kernel, size):
    head, *rows = MODEL.read_text().split()
    rows = [row.split(",") for row in rows]
    chance = random.Random(1)
    text = [head]
    for k in range(size):
        row = rows[k % 63][:]
        if kernel.endswith("*"):
            row[2:] = [repr(float(cell) * chance.uniform(0.9, 1.1)) for cell in row[2:]]
        text.append(",".join([str(k + 1), *row[1:]]))
    path = WORK / f"model-{size}{'-other' if kernel.endswith('*') else ''}.csv"
    path.write_text("\n".join(text) + "\n")
    return path


def figure(value):
    for unit, scale in (("ns", 1), ("µs", 1e3), ("ms", 1e6)):
        if value < 1000 * scale or unit == "ms":
            return f"{value / scale:.3g} {unit}"


def size_of(path):
    return f"{path.stat().st_size / 1000:.0f} kB"


def measure(kernel, size):
    _, number, sources = KERNELS[kernel]
    name = f"{kernel.replace('*', '_other')}{size}"
    is_chain = number < 4
    arguments = [str(size)] + ([str(write_model(kernel, size))] if is_chain else [])
    given = ["--run-args", " ".join(arguments)]
    files, said = {}, ""
    for way, option in WAYS.items():
        files[way] = WORK / f"{name}_{way}.c"
        told = command([SYMREAL, "generate", *sources, *given, *option, "--prefix", way, "-o", files[way]])
        said = told if way == "reroll" else said
    for way in ("reroll", "fast"):
        command([SYMREAL, "verify", *sources, *given, files[way], "--samples=20", "--min-samples=5"])
    loops = re.search(r"compute: \d+ loop.*", said)
    objects = {}
    for way, file in files.items():
        objects[way] = file.with_suffix(".o")
        flags = [*FLAGS, *([] if way == "fast" else KEPT)]
        is_too_long = file.stat().st_size > MOST_MEGABYTES * 1e6
        if is_too_long or command(["gcc", *flags, "-c", file, "-o", objects[way]], MOST_SECONDS) is None:
            del objects[way]
    words = [f"-DKERNEL={number}", f"-DSTRAIGHT={int('straight' in objects)}", "-DNO_MAIN", "-Iinputs/chain"]
    program = WORK / name
    command(["g++", *FLAGS, *words, HERE / "driver.cpp", *(CHAIN if is_chain else []), *objects.values(), "-lm", "-o", program])
    turns = [[float(word) for word in line.split()] for line in command([program, *arguments]).splitlines()]
    times = dict(zip(("original", *WAYS), zip(*turns)))
    if "straight" not in objects:
        del times["straight"]
    return {"size": size, "times": times, "files": files, "loops": loops[0] if loops else "straight-line code"}


def cell(values):
    low, middle, high = statistics.quantiles(values, n=4)
    return f"{figure(middle)} ({figure(low)} to {figure(high)})"


def row(result):
    times, files = result["times"], result["files"]
    gains = [statistics.median(a / b for a, b in zip(times["original"], times[way])) for way in ("reroll", "fast")]
    straight = cell(times["straight"]) if "straight" in times else f"more than {MOST_SECONDS} s or {MOST_MEGABYTES} MB to compile"
    return (f"| {result['size']} | {cell(times['original'])} | {straight} | {cell(times['reroll'])} | {gains[0]:.2g} | "
            f"{cell(times['fast'])} | {gains[1]:.2g} | {size_of(files['straight'])} | {size_of(files['reroll'])} | {size_of(files['fast'])} |")


def section(kernel):
    results = [measure(kernel, size) for size in OTHER_SIZES.get(kernel, SIZES)]
    text = "\n".join([f"## {kernel}: {KERNELS[kernel][0]}", "",
                      "| N | Original | Straight-line code | `--reroll` | Times as fast as the original | `--reroll --fp=fast` | Times as "
                      "fast | File | with `--reroll` | and `--fp=fast` |", "|---:|" + 9 * "---:|", *map(row, results), "",
                      f"N = {results[-1]['size']}: {results[-1]['loops']}. {LOAD:.1f} other processes ran when the run began, on {processor()}.", ""])
    print(text, flush=True)
    return text


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    page = HERE / "results.md"
    known = {text.split(":")[0]: "## " + text.rstrip() + "\n" for text in page.read_text().split("\n## ")[1:]}
    for kernel in sys.argv[1:] or list(KERNELS):
        known[kernel] = section(kernel)
    head = ("# Loops in place of straight-line code\n\n"
            f"Written by bench/reroll/run. All are compiled by gcc with `{' '.join(FLAGS[:2])}`, code of mode finite also with "
            f"`{' '.join(KEPT)}`. A figure is the median of 41 turns, with quartiles. Each file was verified; in mode finite "
            "straight-line code and loops give the same bits.\n")
    page.write_text("\n".join([head, *(known[kernel] for kernel in KERNELS if kernel in known)]))


main()
