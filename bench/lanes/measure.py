"""--vector, scalar code and the original: see bench/lanes/run.

   generate twice ──▶ verify the vectors ──▶ compile all three ──▶ turns of each, one after the other ──▶ table
"""
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
WORK = pathlib.Path("build/bench-lanes").resolve()
CHAIN = [f"inputs/chain/{name}.cpp" for name in ("algorithms", "example", "model", "spatial")]
HEXAHEDRON = "inputs/hexahedron/hexahedron.c"
# name: what is measured, its number in driver.cpp, sources that generate it, the original
KERNELS = {
    "hourglass_force": ("hourglass forces of a hexahedral element", 0, [HEXAHEDRON], [HEXAHEDRON]),
    "deformation_rate": ("rate of deformation of a hexahedral element", 1, [HEXAHEDRON], [HEXAHEDRON]),
    "rnea": ("inverse dynamics of 6 links", 2, ["inputs/chain/rnea.cpp", *CHAIN], CHAIN),
    "aba": ("forward dynamics of 6 links", 3, ["inputs/chain/aba.cpp", *CHAIN], CHAIN),
}
WIDTHS = (2, 4, 8)
FLAGS = ["-O3", "-march=native", "-w"]
COMPILERS = {"gcc": "g++", "clang-19": "clang++-19"}


def command(words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"bench: {' '.join(map(str, words))}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def generate(kernel, sources, prefix, options):
    folder = WORK / f"{kernel}_{prefix}{''.join(options).replace('--vector=', '')}"
    folder.mkdir()
    said = command([SYMREAL, "generate", *sources, *options, "--prefix", prefix, "-o", f"{folder}/"])
    files = [*folder.glob("*.c")]
    file = files[0] if len(files) == 1 else folder / f"{kernel}.c"
    section = said[said.find(f"kernel {kernel}:"):]
    share = re.search(r"compute: (\d+ of \d+) operations", section)
    has_vectors = "SYMREAL_VECTORS" in file.read_text()
    return file, share[1] if share and has_vectors else None


def object_of(compiler, file, output, words=()):
    command([compiler, *FLAGS, *words, "-c", file, "-o", output])
    return output


def turns(kernel, compiler, number, original, scalar, vector):
    words = [f"-DKERNEL={number}", "-Dmain=main_of_original", "-Iinputs/chain"]
    name = f"{kernel}-{compiler}"
    objects = [object_of(compiler, file, WORK / f"{name}-{way}.o") for way, file in (("scalar", scalar), ("vector", vector))]
    for k, file in enumerate(original):
        by = compiler if file.endswith(".c") else COMPILERS[compiler]
        objects.append(object_of(by, file, WORK / f"{name}-original{k}.o", words))
    program = WORK / name
    command(["g++", "-O2", "-w", words[0], words[2], HERE / "driver.cpp", *objects, "-lm", "-o", program])
    lines = command([program]).splitlines()
    return [[float(word) for word in line.split()] for line in lines]


def spread(values):
    low, middle, high = statistics.quantiles(values, n=4)
    return f"{middle:.3g} ({low:.3g} to {high:.3g})"


def rows(kernel):
    _, number, sources, original = KERNELS[kernel]
    scalar, _ = generate(kernel, sources, "scalar", [])
    for width in WIDTHS:
        vector, share = generate(kernel, sources, "vector", [f"--vector={width}"])
        if not share:
            yield f"| {width} | no vectors | | | | | |"
            continue
        command([SYMREAL, "verify", *sources, vector, "--samples=200"])
        for compiler in COMPILERS:
            times = turns(kernel, compiler, number, original, scalar, vector)
            first, second, third = zip(*times)
            yield (f"| {width} | {share} | {compiler} | {statistics.median(first):.3g} ns | "
                   f"{spread([a / b for a, b in zip(first, second)])} | {spread([a / b for a, b in zip(first, third)])} | "
                   f"{spread([a / b for a, b in zip(second, third)])} |")


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    chosen = sys.argv[1:] or list(KERNELS)
    text = ["# Operations side by side", "",
            f"Written by bench/lanes/run on {processor()}, where {os.getloadavg()[0]:.1f} other processes ran when it "
            f"began. The original, scalar code and code of `--vector` are compiled by the same compiler with `{' '.join(FLAGS[:2])}`; the compiler "
            "may fuse and vectorise the original. *As fast as* is a median of 41 turns, with quartiles. Each file was verified, and scalar code and "
            "vectors give the same bits."]
    for kernel in chosen:
        begin = len(text)
        text += ["", f"## {kernel}: {KERNELS[kernel][0]}", "",
                 "| `--vector` | Operations in vectors | Compiler | Original | Scalar: times as fast as it | `--vector`: times as fast as it | "
                 "times as fast as scalar |",
                 "|---:|---:|---|---:|---:|---:|---:|", *rows(kernel)]
        print("\n".join(text[begin:]), flush=True)
    if not sys.argv[1:]:
        (HERE / "results.md").write_text("\n".join(text) + "\n")


main()
