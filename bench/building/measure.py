#!/usr/bin/env python3
"""measure.py [--symreal TOOL] [--sizes flight:1000,kinematics:13000]: how long the compiler takes on large sources in symbolic mode, beside
the original. Writes the sources (sources.py), lets `symreal generate` build them with a compiler that notes its processor time and its most
memory, and prints a row for each: the original with -O1, the bound, what was tried in symbolic mode, and the sum of that."""
import argparse
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
NAMED = {"flight": "flight.c", "kinematics": "kinematics.cpp"}
MOST_TIMES, SECONDS_MORE, MEMORY_TIMES, MEGABYTES_MORE = 10, 1, 5, 300


def as_compiler(compiler, log, arguments):
    """A line for each compilation: processor seconds, megabytes of the largest process, how it ended, the arguments."""
    status = subprocess.run([compiler, *arguments]).returncode
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    if "-c" in arguments:
        with open(log, "a") as out:
            print(f"{used.ru_utime + used.ru_stime:.2f}\t{used.ru_maxrss / 1000:.0f}\t{status}\t{' '.join(arguments)}", file=out)
    sys.exit(status if status >= 0 else 128 - status)


def compiler_in(folder, name, compiler, log):
    path = folder / name
    path.write_text(f'#!/bin/sh\nexec {sys.executable} {HERE}/measure.py --as-compiler {compiler} {log} "$@"\n')
    path.chmod(0o755)
    return path


def of_original(folder, source):
    command = ["gcc" if source.suffix == ".c" else "g++", "-O1", "-w", "-c", source, "-o", folder / "original.o"]
    _, status, used = os.wait4(subprocess.Popen(command).pid, 0)
    assert status == 0
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1000


def tried(line):
    seconds, megabytes, status, arguments = line.rstrip("\n").split("\t")
    words = arguments.split()
    if "-DMBD_SYMBOLIC" not in words:
        return None if not words[-1].endswith(".original") else ("original", float(seconds), float(megabytes), True)
    level = next((word for word in words if word.startswith("-O")), "-O0")
    return level, float(seconds), float(megabytes), status == "0"


def measure(tool, kind, size):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        source, log = folder / NAMED[kind], folder / "log"
        source.write_text(subprocess.run([sys.executable, HERE / "sources.py", kind, str(size)], check=True, capture_output=True, text=True).stdout)
        seconds, megabytes = of_original(folder, source)
        log.write_text("")
        compiler_in(folder, "cc", "gcc", log)
        environment = {**os.environ, "XDG_CACHE_HOME": str(folder / "cache"), "PATH": f"{folder}:{os.environ['PATH']}"}
        command = [tool, "generate", source, "-o", folder / "code.c", "--decisions=guard", "--cxx", compiler_in(folder, "cxx", "g++", log)]
        said = subprocess.run(command, env=environment, capture_output=True, text=True).stderr
        steps = [step for step in map(tried, log.read_text().splitlines()) if step]
        told = "; ".join(f"{level} {step:.1f} s, {memory:.0f} MB{'' if is_done else ', ended'}" for level, step, memory, is_done in steps)
        print(f"| {kind} {size} | {seconds:.1f} s, {megabytes:.0f} MB | {MOST_TIMES * seconds + SECONDS_MORE:.1f} s, "
              f"{MEMORY_TIMES * megabytes + MEGABYTES_MORE:.0f} MB | {told} | {sum(step[1] for step in steps):.1f} s, "
              f"{max((step[2] for step in steps), default=0):.0f} MB |", flush=True)
        for line in said.splitlines():
            if "without optimisation" in line or "error" in line:
                print("  " + line, flush=True)


def main():
    if sys.argv[1:2] == ["--as-compiler"]:
        as_compiler(sys.argv[2], sys.argv[3], sys.argv[4:])
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--symreal", default="build/release/tool/symreal")
    options.add_argument("--sizes", default="flight:1000,kinematics:13000")
    given = options.parse_args()
    print("| Source | Original, -O1 | Bound | Symbolic build | All of it |\n|---|---|---|---|---|")
    for one in given.sizes.split(","):
        kind, size = one.split(":")
        measure(pathlib.Path(given.symreal).resolve(), kind, int(size))


main()
