"""Derivatives by Symreal and its peers, side by side, and the cost of gradients: see bench/derivatives/run.

   generate ──▶ compile ──▶ compare with each other ──▶ turns ──▶ tables
"""
import argparse
import json
import pathlib
import statistics
import struct
import sys
import time
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "peers"))
import contenders  # noqa: E402
import makers  # noqa: E402
import present  # noqa: E402
import rows  # noqa: E402
from problems import LENGTHS, PROBLEMS, VECTORS  # noqa: E402
from work import WORK, Missing, run  # noqa: E402

AGREE, ROUNDS, SECONDS = 1e-9, 31, 8
COMPILE_SECONDS = {"Pinocchio": 300}  # 60 for generated code
GRADIENTS = [8, 16, 32, 64, 128]


def level_of(compiler, operations):
    """What bench/peers compiles with: large code at -O1."""
    return ((contenders.GCC if compiler == "gcc" else contenders.CLANG),
            ["-O1" if operations and operations > contenders.LARGE else "-O3", "-march=native"])


def contender(problem, name, smaller):
    """What was made of it, an object a compiler; or why it is missing. smaller: itself with fewer joints."""
    if smaller and "missing" in smaller:
        return {"missing": smaller["missing"]}
    try:
        made = dict(makers.generated(problem, name))
    except Missing as reason:
        at = f", from N = {problem.joints}" if problem.joints and "more than" in str(reason) else ""
        return {"missing": f"{reason}{at}"}
    made["objects"], why = {}, ""
    for compiler in ("gcc", "clang"):
        try:
            made["objects"][compiler] = contenders.compiled(made["sources"], made["flags"], level_of(compiler, made.get("operations")),
                                                            COMPILE_SECONDS.get(name, 60))
        except Missing as reason:
            why = f"{reason}" + (f", from N = {problem.joints}" if problem.joints else "")
    return made if made["objects"] else {"missing": why, **{key: made[key] for key in ("operations", "generate") if key in made}}


def turns(problem, objects, rounds, seconds):
    vectors = problem.vectors()
    file = WORK / "inputs" / f"derivatives-{problem.name}"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(b"".join(struct.pack(f"{len(vector)}d", *vector) for vector in vectors))
    kernel = problem.name.partition("-")[0]
    return run([WORK / "turns", kernel, problem.joints, contenders.model_table(), file, len(vectors[0]), problem.outputs, rounds, seconds, 1,
                *objects])[0]


def objects_of(row):
    return [(name, compiler, each["object"]) for name, made in row.items() for compiler, each in made.get("objects", {}).items()]


def compare(problem, row):
    """All agree at each vector, relative to the largest number there; values apart from derivatives."""
    first, outputs, own = None, problem.outputs, problem.counts[2]
    for name, compiler, path in objects_of(row):
        numbers = struct.unpack(f"{VECTORS * outputs}d", turns(problem, [path], 0, 0))
        first = first or numbers
        for begin in range(0, len(numbers), outputs):
            for part in (slice(begin, begin + own), slice(begin + own, begin + outputs)):
                distance = max(abs(a - b) for a, b in zip(first[part], numbers[part])) / max(map(abs, first[part]))
                if not distance < AGREE:
                    sys.exit(f"bench: {problem.name}: {name}, {compiler}, is off by {distance:.1e}")


def prepare(problem, smaller):
    with ThreadPoolExecutor(2) as pool:
        made = list(pool.map(lambda name: contender(problem, name, smaller.get(name) if smaller else None), makers.NAMES))
    row = dict(zip(makers.NAMES, made))
    compare(problem, row)
    return row


def measure(problem, row):
    """Quartiles of nanoseconds a call and bytes of code, of the better compiler."""
    every = objects_of(row)
    lines = turns(problem, [path for _, _, path in every], ROUNDS, SECONDS).decode().splitlines()
    for (name, compiler, _), column in zip(every, zip(*(map(float, line.split()) for line in lines))):
        quartiles = statistics.quantiles(column, n=4)
        if quartiles[1] < row[name].get("times", [0, float("inf")])[1]:
            row[name].update(times=quartiles, compiler=compiler, bytes=row[name]["objects"][compiler]["text"])


def gradients():
    """The gradient of a weighted sum of all torques: what it adds to the function, chain by chain."""
    table = []
    for joints in GRADIENTS:
        work = WORK / "derivatives" / f"gradient-{joints}"
        work.mkdir(parents=True, exist_ok=True)
        problem = next(each for each in PROBLEMS if each.name == "rnea-6")
        run([contenders.SYMREAL, "generate", *problem.sources, "-o", work / "k.c", "--graph", work / "k.graph", "--run-args",
             f"{joints} {contenders.model_table()}"])
        counts = []
        for options in ([], ["--differentiate", "vjp(tau, [q, qd, qdd])"]):
            begin = time.monotonic()
            said = run([contenders.SYMREAL, "opt", work / "k.graph", "--lang=c", "-o", work / "g.c", "--json", *options])[0]
            seconds = time.monotonic() - begin
            counts.append(json.loads(said)["operations"]["compute"]["arithmetic"])
        table.append((joints, *counts, seconds))
    return table


def main():
    parser = argparse.ArgumentParser(prog="bench/derivatives/run")
    parser.add_argument("--rows", nargs="+", metavar="ROW", choices=[each.name for each in PROBLEMS], help="only these, to the terminal")
    parser.add_argument("--joints", nargs="+", type=int, default=LENGTHS, help="chains of these lengths, and of 6")
    parser.add_argument("--prepare", action="store_true", help="only generate, compile and compare")
    parser.add_argument("--page", action="store_true", help="only write, from what was measured last")
    arguments = parser.parse_args()
    kept = WORK / "derivatives" / "measured.json"
    if arguments.page:
        return present.write(*json.loads(kept.read_text()))
    rows.build_turns()
    wanted = [each for each in PROBLEMS
              if (each.name in arguments.rows if arguments.rows else each.joints in (0, 6, *arguments.joints))]
    table, smaller = {}, {}
    for problem in wanted:
        kernel = problem.name.partition("-")[0] if problem.joints else None
        table[problem.name] = prepare(problem, smaller.get(kernel))
        smaller[kernel] = table[problem.name] if kernel else None
        print(f"{problem.name}: " + ", ".join(f"{name} {made.get('missing') or made.get('operations', '')}"
                                              for name, made in table[problem.name].items()), flush=True)
    if arguments.prepare:
        return
    for problem in wanted:
        measure(problem, table[problem.name])
    if arguments.rows:
        return print(present.derivatives(table))
    kept.write_text(json.dumps([table, gradients()]))
    present.write(*json.loads(kept.read_text()))


assert set(LENGTHS) <= {each.joints for each in PROBLEMS}
main()
