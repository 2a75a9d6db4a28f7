"""The contenders of a row, a row being a kernel and a number of joints: how each is generated and compiled."""
import csv
import importlib.metadata
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

import chain
import generate
from work import WORK, Missing, digest, remembered, run

HERE = pathlib.Path(__file__).parent
CHAIN = pathlib.Path("inputs/chain")
SYMREAL = os.environ.get("SYMREAL", "build/dev/tool/symreal")
PACKAGES = pathlib.Path(sys.prefix) / f"lib/python3.{sys.version_info[1]}/site-packages"
GENERATE_SECONDS, COMPILE_SECONDS = 60, 30
LARGE = 10_000  # operations in its text from which generated code is compiled by LARGE_LEVELS
LONG = 100  # joints from which mode fast takes effort 1
LOOPS = 32  # joints from which --reroll takes part

GCC, CLANG = ("gcc", "g++"), ("clang-19", "clang++-19")
LEVELS = {
    "gcc -O2": (GCC, ["-O2"]),
    "gcc -O3 -march=native": (GCC, ["-O3", "-march=native"]),
    "clang -O3 -march=native": (CLANG, ["-O3", "-march=native"]),
}
LARGE_LEVELS = {
    "gcc -O1 -march=native": (GCC, ["-O1", "-march=native"]),
    "clang -O1 -march=native": (CLANG, ["-O1", "-march=native"]),
    "clang -O3 -march=native": LEVELS["clang -O3 -march=native"],
}
LINK_TIME = {"gcc -O3 -march=native -flto": (GCC, ["-O3", "-march=native", "-flto"])}
# Compared, not timed: the bits that all others are held against, and what large code gives where no operations are fused.
REFERENCE = {"reference": (GCC, ["-O2", "-ffp-contract=off", "-fno-builtin", "-fno-fast-math"])}
LARGE_REFERENCE = {"reference": (GCC, ["-O0"])}
REFERENCE_SECONDS = 300
CONTRACTED, UNCONTRACTED = ["-ffp-contract=fast"], ["-ffp-contract=off"]
PINOCCHIO = ["-std=c++17", "-isystem", PACKAGES / "cmeel.prefix/include", "-isystem", "/usr/include/eigen3", "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
             "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS", "-DBOOST_FUSION_INVOKE_MAX_ARITY=12"]

PYTHON = {"CasADi": "casadi", "SymForce": "symforce", "wrenfold": "wrenfold"}
PACKAGE = {"CasADi": "casadi", "SymForce": "symforce", "wrenfold": "wrenfold", "CppADCodeGen": "cmeel-cppadcodegen", "Pinocchio": "pin"}
PEERS = ["careful source", *PYTHON, "CppADCodeGen", "Pinocchio"]
MODES = {"Symreal strict": "strict", "Symreal finite": "finite", "Symreal fast": "fast"}
LOOPED = ["Symreal finite --reroll", "Symreal fast --reroll"]
FURTHER = ["careful source, CppADCodeGen", "careful source, Symreal fast", *LOOPED]
ALL = ["original", *PEERS, *MODES, *FURTHER]


def model_table():
    path = WORK / "model.csv"
    if not path.exists():
        rows = chain.model_rows(1000)
        path.parent.mkdir(parents=True, exist_ok=True)
        with open(path, "w", newline="") as file:
            writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
    return path.resolve()


def compiled(sources, flags, level, seconds=COMPILE_SECONDS):
    """A shared object: its path, the seconds of a processor that the compiler took, the bytes of its code."""
    (c, cpp), options = level
    compiler = c if all(str(source).endswith(".c") for source in sources) else cpp
    version = subprocess.run([compiler, "--version"], capture_output=True, text=True).stdout.splitlines()[0]
    key = digest(version, *(pathlib.Path(source).read_text() for source in sources), *flags, *options)

    def make():
        target = WORK / "objects" / f"{key}.so"
        target.parent.mkdir(parents=True, exist_ok=True)
        took = run([compiler, "-w", "-shared", "-fPIC", "-fvisibility=hidden", f"-I{HERE}", f"-I{CHAIN}", *options, *flags, *sources,
                    "-o", target, "-lm"], seconds, "compiling")[2]
        return {"object": str(target), "compile": took["processor"], "text": int(run(["size", target])[0].splitlines()[1].split()[0])}
    return remembered(key, make)


def installed():
    """The versions of the peers that are there."""
    found = {}
    for name, package in PACKAGE.items():
        try:
            found[name] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            pass
    return found


def library(name):
    """The contenders that take any number of joints at run time."""
    if name == "Pinocchio":
        return [HERE / "pinocchio.cpp", CHAIN / "model.cpp", CHAIN / "spatial.cpp"], PINOCCHIO
    algorithms = HERE / "careful.cpp" if name == "careful source" else CHAIN / "algorithms.cpp"
    return [HERE / "original.cpp", algorithms, CHAIN / "model.cpp", CHAIN / "spatial.cpp"], ["-std=c++17"]


def by_python(name, kernel, joints, work):
    said = run([sys.executable, HERE / "generate.py", PYTHON[name], kernel, joints, work], GENERATE_SECONDS, "generating")[0]
    source = next(path for path in (work / "contender.c", work / "contender.cpp") if path.exists())
    flags = ["-std=c++17", "-isystem", "/usr/include/eigen3", "-DEIGEN_MAX_ALIGN_BYTES=0"] if source.suffix == ".cpp" else []
    return {"sources": [str(source)], "flags": [*flags, *CONTRACTED], **json.loads(said)}


def cppadcodegen(algorithms):
    """The program that records inputs/chain, or careful.cpp in its place: copies of the sources with another number type."""
    work = WORK / f"cppadcodegen-{algorithms.stem}"
    work.mkdir(parents=True, exist_ok=True)
    for source, target in [(algorithms, "algorithms.cpp"), *((CHAIN / name, name) for name in
                           ("algorithms.h", "model.h", "model.cpp", "spatial.h", "spatial.cpp"))]:
        text = re.sub(r"\bdouble\b", "Number", source.read_text())
        text = re.sub(r"(?<![\w.])\d+\.\d+(?![\w.])", r"Number(\g<0>)", text)
        (work / target).write_text(re.sub(r"std::(cos|sin)\(", r"\1(", text.replace("constexpr Vector", "Vector const")))
    (work / "number.h").write_text("#include <cppad/cg.hpp>\ntypedef CppAD::AD<CppAD::cg::CG<double>> Number;\n")
    program = work / "record"
    sources = [HERE / "cppadcodegen.cpp", *sorted(work.glob("*.h")), *sorted(work.glob("*.cpp"))]
    key = digest("-DNDEBUG", *(path.read_text() for path in sources))

    def make():
        run(["g++", "-std=c++17", "-O2", "-DNDEBUG", "-w", f"-I{work}", "-isystem", PACKAGES / "cmeel.prefix/include", HERE / "cppadcodegen.cpp", "-o", program,
             f"-L{PACKAGES / 'cmeel.prefix/lib'}", "-lcppad_lib", f"-Wl,-rpath,{(PACKAGES / 'cmeel.prefix/lib').resolve()}"])
        return str(program)
    return remembered(key, make)


def by_cppadcodegen(name, kernel, joints, work):
    algorithms = HERE / "careful.cpp" if name.startswith("careful") else CHAIN / "algorithms.cpp"
    program = cppadcodegen(algorithms)
    code, said, took = run([program, kernel, joints, model_table()], GENERATE_SECONDS, "generating")
    (work / "contender.c").write_text(generate.MAKE.format(code="#include <math.h>\n" + code.decode(), prepare=""))
    record, write = map(float, said.split())
    return {"sources": [str(work / "contender.c")], "flags": CONTRACTED, "operations": generate.operations(code.decode()), "record": record,
            "write": write, "memory": took["memory"]}


def by_symreal(name, kernel, joints, work):
    careful = name.startswith("careful")
    loops = name.endswith("--reroll")
    mode = MODES.get(name.removesuffix(" --reroll")) or "fast"
    options = [f"--effort={1 if joints >= LONG and not loops else 2}"] if mode == "fast" else []
    options += ["--reroll"] if loops else []
    sources = [CHAIN / f"{kernel}.cpp", HERE / "careful.cpp" if careful else CHAIN / "algorithms.cpp", *(CHAIN / f"{other}.cpp" for other in
               ("example", "model", "spatial"))]
    said = run([SYMREAL, "generate", *sources, "-o", work / "code.c", f"--fp={mode}", *options, "--json", "--run-args",
                f"{joints} {shlex.quote(str(model_table()))}", "--", f"-I{CHAIN}"], GENERATE_SECONDS, "generating")[0]
    report = json.loads(said)["kernels"][0]
    (work / "contender.c").write_text(generate.MAKE.format(code='#include "code.c"', prepare=(
        "static double constants[constant_count + 1];\n"
        "static void evaluate(double const *x, double *y) { compute(x, constants, y); }\n")))
    text = (work / "contender.c").read_text().replace('#include "code.c"', (work / "code.c").read_text().replace(
        '#include "code.h"', (work / "code.h").read_text()))
    (work / "contender.c").write_text(text)
    operations = report["operations"]
    return {"sources": [str(work / "contender.c")], "flags": CONTRACTED if mode == "fast" else [*UNCONTRACTED, "-fno-tree-slp-vectorize"]
            if mode == "finite" else UNCONTRACTED,
            "operations": operations.get("with loops", operations["compute"])["arithmetic"], "executed": operations["executed"]["arithmetic"],
            "recorded": operations["recorded"]["arithmetic"], "record": report["seconds"]["run"], "write": report["seconds"]["optimise and emit"]}


def generated(name, kernel, joints):
    maker = by_python if name in PYTHON else by_cppadcodegen if "CppADCodeGen" in name else by_symreal
    sources = [HERE / other for other in ("chain.py", "generate.py", "careful.cpp", "cppadcodegen.cpp")] + sorted(CHAIN.glob("*.[ch]*"))
    tool = pathlib.Path(SYMREAL).stat() if maker is by_symreal else None
    key = digest(name, kernel, joints, LONG, (tool.st_mtime_ns, tool.st_size) if tool else (HERE / "requirements.txt").read_text(),
                 *(path.read_text() for path in sources))

    def make():
        work = WORK / "code" / f"{kernel}-{joints}" / name.replace(" ", "_").replace(",", "")
        work.mkdir(parents=True, exist_ok=True)
        try:
            return maker(name, kernel, joints, work)
        except SystemExit as failure:
            if maker is by_symreal:
                raise
            print(failure, flush=True)
            raise Missing("its generator fails") from None
    return remembered(key, make)


def contender(name, kernel, joints, smaller):
    """One contender of a row: its counts and its variants, one a compiler; or why it is missing. smaller: itself with fewer joints."""
    if smaller and "missing" in smaller:
        return {"missing": smaller["missing"] if smaller["missing"].endswith("joints") else f"{smaller['missing']} at {smaller['joints']} joints"}
    result = {"joints": joints, "variants": {}}
    try:
        if any(peer in name and peer not in installed() for peer in PACKAGE):
            raise Missing("not available here")
        if name in ("original", "careful source", "Pinocchio"):
            sources, flags = library(name)
            levels = {**LEVELS, **LINK_TIME, **REFERENCE} if name == "original" else LEVELS
            seconds = 300 if name == "Pinocchio" else COMPILE_SECONDS
        else:
            made = generated(name, kernel, joints)
            result.update({key: value for key, value in made.items() if key not in ("sources", "flags")})
            sources, flags, seconds = made["sources"], made["flags"], COMPILE_SECONDS
            result["written"] = written(name, made)
            levels = LEVELS
            if result["written"] > LARGE:
                levels = {**LARGE_LEVELS, **LARGE_REFERENCE} if name in PEERS else LARGE_LEVELS
    except Missing as reason:
        return {"missing": str(reason), "joints": joints}
    reasons = {}
    for level, how in levels.items():
        allowed = REFERENCE_SECONDS if level == "reference" else seconds
        try:
            if smaller and expected(smaller, level, result) > allowed:
                raise Missing(f"compiling would take more than {allowed} s, as it grows")
            result["variants"][level] = compiled(sources, flags, how, allowed)
        except Missing as reason:
            reasons[level] = str(reason)
    return result if set(result["variants"]) - {"reference"} else {"missing": next(iter(reasons.values())), **result}


def written(name, made):
    """Operations in the text of a contender: loops compute each many times."""
    return generate.operations(pathlib.Path(made["sources"][0]).read_text()) if name in LOOPED else made["operations"]


def expected(smaller, level, result):
    """Seconds to compile, from those of the smaller code: they grow faster than its text."""
    before = [variant["compile"] for other, variant in smaller.get("variants", {}).items() if other.split()[0] == level.split()[0]]
    if not before or "written" not in result or smaller["written"] < 1000:
        return 0
    return min(before) * (result["written"] / smaller["written"]) ** 1.1
