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
import time

HERE = pathlib.Path(__file__).resolve().parent
NAMED = {"flight": "flight.c", "kinematics": "kinematics.cpp"}
MOST_TIMES, SECONDS_MORE, MEMORY_TIMES, MEGABYTES_MORE = 10, 1, 5, 300


def used_by_group():
    """Processor seconds and megabytes of this process's group, the largest of them."""
    seconds, memory = 0, 0
    for path in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if os.getpgid(int(path.name)) != os.getpgrp() or int(path.name) == os.getpid():
                continue
            seconds += sum(map(int, (path / "stat").read_text().rsplit(")", 1)[1].split()[11:15])) / os.sysconf("SC_CLK_TCK")
            memory = max(memory, *(int(line.split()[1]) / 1000 for line in (path / "status").read_text().splitlines() if line.startswith("VmHWM")))
        except (OSError, TypeError):
            continue  # it has ended
    return seconds, memory


def as_compiler(compiler, log, arguments):
    """A line for each compilation: processor seconds, megabytes of the largest process, how it ended, the arguments. The tool ends one that
    goes beyond its share, with this process; its last line stays."""
    run = subprocess.Popen([compiler, *arguments])
    line = pathlib.Path(f"{log}.{os.getpid()}")

    def note(seconds, memory, status):
        new = pathlib.Path(f"{log}-{os.getpid()}")
        new.write_text(f"{seconds:.2f}\t{memory:.0f}\t{status}\t{' '.join(arguments)}\n")
        new.replace(line)

    while True:
        ended, status, used = os.wait4(run.pid, os.WNOHANG)
        if ended:
            break
        if "-c" in arguments:
            note(*used_by_group(), "ended")
        time.sleep(0.05)
    if "-c" in arguments:
        note(used.ru_utime + used.ru_stime, used.ru_maxrss / 1000, status)
    sys.exit(1 if status else 0)


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
        compiler_in(folder, "cc", "gcc", log)
        environment = {**os.environ, "XDG_CACHE_HOME": str(folder / "cache"), "PATH": f"{folder}:{os.environ['PATH']}"}
        command = [tool, "generate", source, "-o", folder / "code.c", "--decisions=guard", "--cxx", compiler_in(folder, "cxx", "g++", log)]
        said = subprocess.run(command, env=environment, capture_output=True, text=True).stderr
        lines = [path.read_text() for path in sorted(folder.glob("log.*"), key=os.path.getmtime)]
        steps = [step for step in map(tried, lines) if step]
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
