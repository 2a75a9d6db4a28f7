"""Code in which two threads share an evaluation, against code for one: see bench/threads/run.

   generate ──▶ opt ──▶ C for one thread ──┐
                └─────▶ C with sections ───┴▶ build ──▶ turns of both ──▶ table

Where the costs say that it does not pay, there is no code: the table has what the diagnostic says.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from measure import CHAIN, FLAGS, HERE, ROUNDS, SYMREAL, TURN, WORK, command, quartiles, shown

LINKS = {"arm": (1, 64), "arms-16": (2, 16), "arms-32": (2, 32), "arms-64": (2, 64)}


def measure(name, costs):
    arms, links = LINKS[name]
    what = f"{arms} arm{'s' if arms > 1 else ''} of {links} joints"
    where = WORK / name
    shutil.rmtree(where, ignore_errors=True)
    where.mkdir(parents=True)
    command([SYMREAL, "generate", HERE / "arms.cpp", *CHAIN, "--run-args", links, "--graph", where / "recorded.graph",
             "-o", where / "one.c", "--prefix", "one", "--", "-Iinputs/chain", f"-DARMS={arms}"])
    command([SYMREAL, "opt", where / "recorded.graph", "--lang=graph", "-o", where / "optimised.graph"])
    done = subprocess.run([SYMREAL, "opt", where / "optimised.graph", "--passes=none", "--lang=c", "--prefix=all", "--parallel=2",
                           f"--cost={costs}", "-o", where / "all.c"], capture_output=True, text=True)
    said = re.sub(r"^(symreal: error: )?kernel '?\w+'?: ", "", done.stderr.splitlines()[0])
    text = (where / "optimised.graph").read_text()
    operations = json.loads(command([SYMREAL, "analyze", where / "optimised.graph", "--json"]))["work"]
    if done.returncode != 0:
        return what, operations, said, None
    values = " ".join(line.rsplit(" = ", 1)[1] for line in re.findall(r"^input .*$", text, re.MULTILINE)).split()
    outputs = len(re.findall(r"^result ", text, re.MULTILINE))
    (where / "values.h").write_text(f"#define INPUTS {len(values)}\n#define OUTPUTS {outputs}\n#define VALUES {', '.join(values)}\n")
    command(["gcc", *FLAGS, "-fopenmp", f"-I{where}", HERE / "sections.c", where / "one.c", where / "all.c", "-lm", "-o",
             where / "sections"])
    once = max(map(float, command([where / "sections", 1, 3]).split()[-2:]))
    calls = max(1, int(TURN/once))
    rows = [[float(word) for word in line.split()] for line in command([where / "sections", calls, ROUNDS]).splitlines()]
    return what, operations, said, ([quartiles(column) for column in zip(*rows)], quartiles([one/all_ for one, all_ in rows]))


def row(what, operations, said, measured):
    if measured is None:
        return f"| {what} | {operations} | | | none: {said} | |"
    (one, both), gain = measured
    times = lambda one: f"{shown(one[0])} ({shown(one[1])} to {shown(one[2])}), quickest {shown(one[3])}"
    quickest = one[3]/both[3]
    said = re.search(r"([\d.]+) times as fast", said).group(1)
    return f"| {what} | {operations} | {times(one)} | {times(both)} | {said} | {gain[0]:.2f} ({gain[1]:.2f} to {gain[2]:.2f}), of the quickest {quickest:.2f} |"


def main():
    load = f"{os.getloadavg()[0]:.1f}"
    WORK.mkdir(parents=True, exist_ok=True)
    costs = pathlib.Path(os.environ.get("COSTS", WORK / "costs.json"))
    if "COSTS" not in os.environ:
        command([SYMREAL, "measure-costs", "-o", costs])
    machine = json.loads(costs.read_text())["threads"]
    lines = ["# Threads that share an evaluation", "",
             f"Written by bench/threads/run: `symreal opt --parallel=2`, gcc -O2 -fopenmp. {machine['processors']} processors on "
             f"{machine['cores']} cores; {load} other processes ran on average when it began. Of {ROUNDS} turns medians, with quartiles "
             f"in parentheses: where other processes take a processor away, threads that wait for each other lose a slice of time. A region of two empty sections takes {machine['sections'][0]['nanoseconds']:.0f} ns by "
             f"`symreal measure-costs`, a hand-over {machine['hand_over']:.0f} ns.", "",
             "| Forward dynamics | Operations | On one thread | On two | Said to be so many times as fast | Is |",
             "|---|---:|---:|---:|---:|---:|"]
    for name in sys.argv[1:] or LINKS:
        lines.append(row(*measure(name, costs)))
        print(lines[-1], file=sys.stderr)
    if not sys.argv[1:]:
        (HERE / "sections.md").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
