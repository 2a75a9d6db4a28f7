#!/usr/bin/env python3
"""same_in.py LANGUAGE BASE [--library LIBRARY] [--real float] [--ulps FILE] [--all-operations TABLE RUNS | INPUTS...]: builds and runs the main program of
LANGUAGE (BASE_main.*) and that of C beside it, and compares their outputs for each list of inputs. Numbers must have the
same bits, but for the units in the last place that FILE grants to an output op_NAME of this language ("javascript sin
1") and to others ("javascript * 2"); any NaN equals any NaN. Both must end with the same status and tell the same guard.
Where a language has no infinities, FILE says so ("mathematica values finite"): operands are finite then, an output that is
not finite in C is not compared; and where it has no negative zero ("mathematica zeros unsigned"), -0 equals 0. Of programs
in single precision units are those of floats, and FILE calls the language java_float. External functions are in LIBRARY.a,
and for Python in LIBRARY.so."""
import argparse
import math
import os
import struct
import subprocess
import sys

import in_one_process
import maple_reader

HERE = os.path.dirname(os.path.abspath(__file__))
# A run of a second or two has its machine code made in one stage and its garbage collected by one thread.
JAVAC = ["javac", "-J-Xshare:auto", "-J-XX:TieredStopAtLevel=1", "-J-XX:+UseSerialGC"]


def build(language, base, library):
    """A function that runs the program, after what it takes to build it."""
    if language in in_one_process.LANGUAGES:
        return in_one_process.Runs(language, base)
    if language == "maple":
        return maple_reader.Runs(language, base)
    where, name = os.path.split(os.path.abspath(base))
    linked = [f"{library}.a"] if library else []
    run = {
        "javascript": [["node", f"{name}_main.mjs"]],
        "java": [[*JAVAC, "-Xlint:all", "-Werror", "-d", f"{name}.classes", f"{name}.java", f"{name}_main.java"],
                 ["java", "-Xshare:auto", "-cp", f"{name}.classes", f"{name}_main"]],
        "go": [["go", "build", "-o", f"{name}.run_go", f"{name}.go", f"{name}_main.go"], [f"./{name}.run_go"]],
        "rust": [["rustc", "--edition", "2021", "-D", "warnings", "-C", "opt-level=1", f"{name}_main.rs", "-o",
                  f"{name}.run_rust"] + [f"-Clink-arg={file}" for file in linked], [f"./{name}.run_rust"]],
        "fortran": [["gfortran", "-std=f2018", "-Wall", "-Wextra", "-Werror", "-Wno-compare-reals", "-Wno-unused-dummy-argument", "-O1",
                     "-ffp-contract=off", f"{name}.f90", f"{name}_main.f90", *linked, "-o", f"{name}.run_fortran"],
                    [f"./{name}.run_fortran"]],
        "cpp": [["g++", "-std=c++17", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-O1", "-ffp-contract=off", f"{name}.cpp",
                 f"{name}_main.cpp", *linked, "-o", f"{name}.run_cpp"], [f"./{name}.run_cpp"]],
        "python": [["/usr/bin/python3", "-W", "error", f"{name}_main.py"]],
        "matlab": [["octave-cli", "--quiet", "--norc", "--no-history", f"{name}_main.m"]],
    }[language]
    environment = dict(os.environ, GO111MODULE="off", GOFLAGS="", PYTHONDONTWRITEBYTECODE="1")
    if library and language == "python":
        environment["LD_PRELOAD"] = f"{library}.so"
    for command in run[:-1]:
        subprocess.run(command, cwd=where, check=True, env=environment)
    return lambda inputs: subprocess.run(run[-1] + inputs, cwd=where, capture_output=True, text=True, env=environment)


def build_c(base, library):
    """The same for C. Other languages may have had it built before."""
    where, name = os.path.split(os.path.abspath(base))
    program, sources = f"{name}.run_c", [f"{name}.c", f"{name}.h", f"{name}_main.c", *([f"{library}.a"] if library else [])]
    command = ["gcc", "-std=c99", "-O1", "-ffp-contract=off", "-fno-builtin", *(source for source in sources if not source.endswith(".h")), "-lm", "-o", program]
    built = os.path.join(where, program + ".command")

    def time(file):
        return os.stat(os.path.join(where, file)).st_mtime_ns

    if not os.path.exists(built) or open(built).read() != " ".join(command) or any(time(source) >= time(program) for source in sources):
        subprocess.run(command, cwd=where, check=True)
        open(built, "w").write(" ".join(command))
    return lambda inputs: subprocess.run([f"./{program}"] + inputs, cwd=where, capture_output=True, text=True)


def ordered(x, is_float):
    """Numbers as integers in their order: neighbours differ by 1, and -0 is 0."""
    bits = struct.unpack("<i", struct.pack("<f", x))[0] if is_float else struct.unpack("<q", struct.pack("<d", x))[0]
    return bits if bits >= 0 else -(bits & (0x7FFFFFFF if is_float else 0x7FFFFFFFFFFFFFFF))


def distance(x, y, is_float, limits=()):
    if "finite" in limits and not math.isfinite(x):
        return 0
    if "unsigned" in limits and x == y == 0:
        return 0
    if math.isnan(x) or math.isnan(y):
        return 0 if math.isnan(x) and math.isnan(y) else math.inf
    if x == y:
        return 0 if math.copysign(1, x) == math.copysign(1, y) else math.inf
    if math.isinf(x) or math.isinf(y):
        return math.inf
    return abs(ordered(x, is_float) - ordered(y, is_float))


def outputs(text):
    return [(name, float(value)) for name, value in (line.rsplit(" = ", 1) for line in text.splitlines())]


def granted(path, language):
    table = {}
    for line in open(path) if path else []:
        words = line.split("#")[0].split()
        if words and words[0] == language:
            table[words[1]] = words[2] if words[1] in ("values", "zeros") else float(words[2])
    return table


def messages(text):
    # What Octave 7 says now and then at its end, of itself.
    return text.replace("error: ignoring const execution_exception& while preparing to exit", "").split()


def compare(expected, got, ulps, worst, is_float):
    problems = []
    if expected.returncode != got.returncode:
        problems.append(f"ends with {got.returncode}, not {expected.returncode}: {got.stderr}")
    if expected.stderr.split() != messages(got.stderr):
        problems.append(f"tells '{got.stderr}', not '{expected.stderr}'")
    if problems:
        return problems
    left, right = outputs(expected.stdout), outputs(got.stdout)
    if [name for name, _ in left] != [name for name, _ in right]:
        return [f"prints {[name for name, _ in right]}"]
    for (name, x), (_, y) in zip(left, right):
        operation = name[3:] if name.startswith("op_") else "*"
        far = distance(x, y, is_float, [ulps.get("values"), ulps.get("zeros")])
        worst[operation] = max(worst.get(operation, 0), far)
        if far > ulps.get(operation, 0):
            problems.append(f"{name} = {y!r}, in C {x!r}: {far} units in the last place")
    return problems


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("language")
    parser.add_argument("base")
    parser.add_argument("--real", default="double", choices=["double", "float"])
    parser.add_argument("--ulps")
    parser.add_argument("--library")
    parser.add_argument("--all-operations", nargs=2)
    parser.add_argument("--show", action="store_true", help="print the largest distance of each operation")
    options, runs = parser.parse_known_args()
    is_float = options.real == "float"
    lists = [run.split() for run in runs] or [[]]
    ulps = granted(options.ulps, options.language + ("_float" if is_float else ""))
    if options.all_operations:
        table, count = options.all_operations
        words = ["--finite"] * (ulps.get("values") == "finite") + ["--real", "float"] * is_float
        lists = [subprocess.run([sys.executable, f"{HERE}/all_operations.py", "--inputs", str(run), table, *words],
                                check=True, capture_output=True, text=True).stdout.split() for run in range(int(count))]
    in_c, in_it, worst, failed = build_c(options.base, options.library), build(options.language, options.base, options.library), {}, False
    if hasattr(in_it, "prepare"):
        in_it.prepare(lists)
    for run, inputs in enumerate(lists):
        expected, got = in_c(inputs), in_it(inputs)
        problems = compare(expected, got, ulps, worst, is_float)
        for problem in problems:
            print(f"run {run}: {problem}")
        failed = failed or bool(problems)
        if not options.all_operations:
            print(expected.stdout + expected.stderr, end="")
    if options.show:
        for operation, far in sorted(worst.items()):
            if far:
                print(f"{options.language} {operation} {far}")
    sys.exit(1 if failed else 0)


main()
