"""How fast a program records, and its graph becomes code: see bench/recording/run."""
import argparse
import itertools
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import time

sys.path.append(str(pathlib.Path(__file__).parents[1]))
from hardware import processor  # noqa: E402

SOURCES = [f"inputs/chain/{source}.cpp" for source in ("algorithms", "example", "model", "spatial")]
COLUMNS = {"no columns": ("0", "0"), "values": ("1", "0"), "values and places": ("1", "1")}
HEAD = """# Recording, and from the graph to code

Written by `bench/recording/run` on {cpu}, {count} processors. The dense chain of `inputs/chain`: `aba` its forward dynamics,
`crba` its mass matrix. *Executed* operations are those that the program did while it was recorded; *nodes* are what is left
of them when nothing is computed twice. Times are those of the processor (user and system), in seconds: the median of the
rounds and, behind it, the lowest and the highest. Rates are in millions a second. Memory is the most that a process held.

"""


def spread(values, digits=3):
    return f"{statistics.median(values):.{digits}f} ({min(values):.{digits}f}-{max(values):.{digits}f})"


def table(titles, rows):
    return "\n".join("| " + " | ".join(map(str, row)) + " |" for row in [titles, ["---"] * len(titles), *rows]) + "\n\n"


def run(command, environment=None):
    """Processor seconds, seconds, megabytes."""
    start = time.monotonic()
    child = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    message = child.stderr.read()
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise SystemExit(f"{command}: status {child.returncode}\n{message}")
    return usage.ru_utime + usage.ru_stime, time.monotonic() - start, usage.ru_maxrss / 1024, message


def write_links(path, count):
    head, *links = pathlib.Path("inputs/chain/data/chain-model.csv").read_text().splitlines()
    path.write_text("\n".join([head, *itertools.islice(itertools.cycle(links), count)]) + "\n")


def generate(symreal, kernel, joints, links, output, *options):
    return run([symreal, "generate", f"inputs/chain/{kernel}.cpp", *SOURCES, "-o", output, "--run-args",
                f"{joints} {links}", *options])


def program_of(symreal, kernel, links, work):
    """The program that records, which the tool builds."""
    message = generate(symreal, kernel, 2, links, work / f"{kernel}.c", "--keep")[3]
    directory = pathlib.Path(re.search(r"the build directory is (\S+)", message).group(1))
    shutil.copy(directory / "symbolic" / "program", work / kernel)
    shutil.rmtree(directory)
    return work / kernel


def recorded(program, joints, links, columns, work):
    shutil.rmtree(work / "recording", ignore_errors=True)
    (work / "recording").mkdir()
    values, places = columns
    return run([program, str(joints), links],
               {**os.environ, "SYMREAL_REQUEST": f"record={work / 'recording'};kernels=1;values={values};places={places}"})


def stages_of(work, rounds):
    """Per stage: seconds of each round, operations, megabytes."""
    lines = subprocess.run([work / "stages", work / "recording" / "0.graph", work / "stages.c", str(rounds)], check=True,
                           capture_output=True, text=True).stdout.splitlines()
    result = {}
    for name, seconds, operations, megabytes in (line.split("\t") for line in lines):
        times = result.setdefault(name, ([], int(operations), []))
        times[0].append(float(seconds))
        times[2].append(float(megabytes))
    return result


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--symreal", required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--kernels", nargs="*", default=["aba", "crba"])
    parser.add_argument("--joints", type=int, nargs="*", default=[64, 256, 1000])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", action="store_true", help="print, and write nothing")
    arguments = parser.parse_args()
    work, rounds = arguments.work, range(arguments.rounds)
    links = work / "links.csv"
    write_links(links, max(arguments.joints))
    recording, stages, whole = [], [], []
    for kernel in arguments.kernels:
        program = program_of(arguments.symreal, kernel, links, work)
        for joints in arguments.joints:
            runs = {name: [recorded(program, joints, links, columns, work) for _ in rounds]
                    for name, columns in COLUMNS.items()}
            measured = stages_of(work, arguments.rounds)
            executed, nodes = measured.pop("executed")[1], measured.pop("nodes")[1]
            recording.append([kernel, joints, executed, nodes,
                              *(spread([executed / 1e6 / one[0] for one in of_columns], 1) for of_columns in runs.values()),
                              f"{max(one[2] for one in runs['values and places']):.0f}"])
            for name, (seconds, operations, megabytes) in measured.items():
                stages.append([kernel, joints, name, operations, spread(seconds),
                               f"{operations / 1e6 / statistics.median(seconds):.1f}", f"{max(megabytes):.0f}"])
            runs = [generate(arguments.symreal, kernel, joints, links, work / "whole.c") for _ in rounds]
            run_stage = [float(re.search(r"run (\S+) s", one[3]).group(1)) for one in runs]
            whole.append([kernel, joints, executed, spread([one[0] for one in runs]), spread([one[1] for one in runs]),
                          f"{max(one[2] for one in runs):.0f}", spread(run_stage, 2),
                          f"{executed / 1e6 / statistics.median(run_stage):.1f}"])
            print(recording[-1], whole[-1], flush=True)
    columns = subprocess.run([work / "columns"], check=True, capture_output=True, text=True).stdout
    text = HEAD.format(cpu=processor(), count=os.cpu_count())
    text += "## Recording\n\nThe whole program: it starts, records, hands the graph over. Rates are of executed operations.\n\n"
    text += table(["kernel", "joints", "executed", "nodes", *COLUMNS, "MB"], recording)
    text += ("Products and sums of 6x6 matrices alone, without start and end; nanoseconds an operation, each of which becomes "
             "a node:\n\n```\n" + columns + "```\n\n")
    text += "## Stages\n\nRates are of the operations that a stage is given.\n\n"
    text += table(["kernel", "joints", "stage", "operations", "seconds", "rate", "MB"], stages)
    text += ("## The whole\n\n`symreal generate`, the objects compiled before. The *run* stage: the program records and hands its "
             "graph over, the tool reads it; its rate is of executed operations.\n\n")
    text += table(["kernel", "joints", "executed", "seconds of the processor", "seconds", "MB", "run", "rate"], whole)
    print(text)
    if not arguments.only:
        (pathlib.Path(__file__).parent / "results.md").write_text(text.rstrip() + "\n")


if __name__ == "__main__":
    main()
