"""All contenders side by side: see bench/peers/run.

   prepare   generate ──▶ compile ──▶ compare outputs         build/bench/peers
   measure   turns ──▶ build/bench/peers/rows.json
   page      bench/peers/benchmarks.md, its plots and CSV, bench/peers/results.md, the README's table
"""
import argparse
import json
import math
import time

import contenders
import generate
import rows
from work import WORK

SIZES = [1, 2, 4, 6, 8, 16, 32, 64, 256, 1000]
MATRIX = 256  # joints of the largest mass matrix
TABLE = WORK / "rows.json"


def check_chain():
    """chain.py computes what inputs/chain computes."""
    joints = 6
    vectors = [[first + step * i for i in range(joints)] for first, step in ((0.3, 0.2), (0.5, -0.1), (-0.4, 0.3))]
    with open(generate.chain.DATA / "chain-reference.csv") as file:
        known = [row for row in generate.chain.csv.DictReader(file) if int(row["N"]) == joints]
    for kernel, (_, parts) in generate.KERNELS.items():
        computed = generate.outputs(kernel, joints, math, vectors[:parts])
        of_kernel = [row for row in known if row["algorithm"].lower() == kernel]
        if not of_kernel or any(abs(computed[int(row["output"])] - float(row["value"])) > 1e-11 for row in of_kernel):
            raise SystemExit(f"bench: chain.py is wrong: {kernel}")


def all_rows(sizes, names, visit):
    table = []
    for kernel in generate.KERNELS:
        smaller = None
        for joints in sizes:
            if kernel == "crba" and (joints > MATRIX or joints == 1):
                continue  # the mass matrix of one joint depends on no input
            begin = time.perf_counter()
            smaller = row = rows.prepare(kernel, joints, smaller, names)
            said = visit(kernel, joints, row)
            table.append({"kernel": kernel, "joints": joints, "contenders": row})
            print(f"{kernel} {joints}: {said}, {time.perf_counter() - begin:.0f} s", flush=True)
    return table


def prepared(kernel, joints, row):
    there = [name for name, contender in row.items() if "missing" not in contender]
    return f"{len(there)} of {len(row)} contenders agree"


def main():
    parser = argparse.ArgumentParser(prog="bench/peers/run")
    parser.add_argument("--small", action="store_true", help="six joints only, few turns; writes nothing in the tree")
    parser.add_argument("--prepare", action="store_true", help="only generate, compile and compare")
    parser.add_argument("--measure", action="store_true", help="only measure what was prepared, and write the page")
    parser.add_argument("--page", action="store_true", help="only write the page from what was measured last")
    parser.add_argument("--joints", type=int, nargs="*", default=SIZES, help="chains of these lengths; 6 must be among them")
    arguments = parser.parse_args()
    import page

    sizes = [6] if arguments.small else arguments.joints
    rounds, launches, seconds = (9, 2, 3.0) if arguments.small else (15, 3, 4.0)
    if not arguments.page:
        check_chain()
        rows.build_turns()
        if not arguments.measure:
            all_rows(sizes, contenders.ALL, prepared)
        if arguments.prepare:
            return

        def measured(kernel, joints, row):
            rows.measure(kernel, joints, row, rounds, launches, seconds)
            return page.summary(row)
        table = all_rows(sizes, contenders.ALL, measured)
        if arguments.small:
            return
        TABLE.write_text(json.dumps({"rows": table, "machine": page.machine(), "launches": launches, "rounds": rounds}))
    page.write(json.loads(TABLE.read_text()))


main()
