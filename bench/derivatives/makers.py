"""How each contender of a problem is generated: sources and flags for the compiler, operations, seconds."""
import json
import re
import sys

import contenders
import differentiate
from work import WORK, Missing, digest, remembered, run

HERE = contenders.HERE.parent / "derivatives"
GENERATE_SECONDS = 60
PEERS = ["CasADi", "SymForce", "CppADCodeGen", "Pinocchio"]
NAMES = ["Symreal finite", "Symreal fast", *PEERS]


def folder(problem, name):
    path = WORK / "derivatives" / problem.name / name.replace(" ", "_")
    path.mkdir(parents=True, exist_ok=True)
    return path


def ends(values, first, count):
    return "{" + ", ".join(repr(value) for value in values[first:first + count]) + "}"


def symreal(problem, name, work):
    x, z, y = problem.counts
    mode = name.split()[1]
    if problem.joints:
        result = "tau" if problem.name.startswith("rnea") else "qdd"
        asked = f"jacobian({result}, [q, qd])"
        words = ["--run-args", f"{problem.joints} {contenders.model_table()}"]
    else:
        asked = f"{problem.derivative}(y, x)"
        words = ["--kernel", f"model(x[0:{x}]={ends(problem.near, 0, x)}, z[0:{z}]={ends(problem.near, x, z)}) -> y[0:{y}]"]
    effort = ["--effort=1"] if mode == "fast" and problem.joints >= contenders.LONG else []
    said = run([contenders.SYMREAL, "generate", *problem.sources, "-o", work / "code.c", f"--fp={mode}", *effort, *problem.options,
                "--differentiate", asked, "--json", *words, "--", "-Iinputs/dh", *problem.flags], 4 * GENERATE_SECONDS, "generating")[0]
    report = json.loads(said)["kernels"][0]
    code = (work / "code.c").read_text().replace('#include "code.h"', (work / "code.h").read_text())
    (work / "contender.c").write_text(differentiate.MAKE.format(code=code, prepare=(
        "static double constants[constant_count + 1];\n"
        "static void evaluate(double const *x, double *y) { compute(x, constants, y); }\n")))
    flags = contenders.CONTRACTED if mode == "fast" else [*contenders.UNCONTRACTED, "-fno-tree-slp-vectorize"]
    return {"operations": report["operations"]["compute"]["arithmetic"], "sources": [str(work / "contender.c")], "flags": flags,
            "generate": report["seconds"]["run"] + report["seconds"]["optimise and emit"]}


def by_python(problem, name, work):
    said = run([sys.executable, HERE / "differentiate.py", name, problem.name, work], GENERATE_SECONDS, "generating")[0]
    source = next(path for path in (work / "contender.c", work / "contender.cpp") if path.exists())
    flags = ["-std=c++17", "-isystem", "/usr/include/eigen3", "-DEIGEN_MAX_ALIGN_BYTES=0"] if source.suffix == ".cpp" else []
    return {**json.loads(said), "sources": [str(source)], "flags": [*flags, *contenders.CONTRACTED]}


CHAIN = """struct Prepared {{
  chain::Model model;
  Prepared(char **words) : model(chain::read_links(words[1], std::atoi(words[0]))) {{}}
}};
static void evaluate(Prepared const &prepared, Number *x, Number *z, Number *y) {{
  chain::{method}(prepared.model, x, x + prepared.model.size(), z, y);
}}
"""
MODEL = """struct Prepared {
  Prepared(char **) {}
};
static void evaluate(Prepared const &, Number *x, Number *z, Number *y) { model(x, z, y); }
"""


def cppadcodegen(problem, name, work):
    """The sources with Number in place of double, without their programs, behind one another."""
    for place, source in enumerate(problem.sources):
        for file in [*source.parent.glob("*.h"), source]:
            text = re.sub(r"\bdouble\b", "Number", file.read_text())
            text = re.sub(r"std::(cos|sin|sqrt|exp|log|atan2|fmax|lgamma|pow)\(", r"\1(", text)
            text = re.sub(r"\bint main\(.*", "", text, flags=re.DOTALL).replace("constexpr Vector", "Vector const")
            name = file.name if file.suffix == ".h" else f"{place}_{file.name}"
            (work / name).write_text(re.sub(r"^#pragma symreal.*\n", "", text, flags=re.MULTILINE))
    if problem.joints:
        method = "inverse_dynamics" if problem.name.startswith("rnea") else "forward_dynamics"
        files, adapter = ["1_algorithms.cpp", "3_model.cpp", "4_spatial.cpp"], CHAIN.format(method=method)
    else:
        files, adapter = [f"{place}_{source.name}" for place, source in enumerate(problem.sources)], MODEL
    (work / "recorded.h").write_text("".join(f'#include "{file}"\n' for file in files) + adapter)
    packages = contenders.PACKAGES / "cmeel.prefix"
    texts = [path.read_text() for path in sorted(work.glob("*.h")) + [work / file for file in files] + [HERE / "record.cpp"]]
    key = digest("record", *problem.flags, *texts)

    def build():
        program = WORK / "derivatives" / f"record-{key}"
        run(["g++", "-std=c++17", "-O1", "-DNDEBUG", "-w", f"-I{work}", *problem.flags, "-isystem", packages / "include", HERE / "record.cpp",
             "-o", program, f"-L{packages / 'lib'}", "-lcppad_lib", f"-Wl,-rpath,{(packages / 'lib').resolve()}"])
        return str(program)
    program = remembered(key, build)
    words = [problem.joints, contenders.model_table()] if problem.joints else []
    code, said, _ = run([program, problem.derivative, *problem.counts, *words], GENERATE_SECONDS, "generating")
    (work / "contender.c").write_text(differentiate.MAKE.format(code=code.decode(), prepare=""))
    return {"operations": differentiate.operations(code.decode().partition("static void")[2]), "generate": float(said),
            "sources": [str(work / "contender.c")], "flags": contenders.CONTRACTED}


def pinocchio(problem, name, work):
    if not problem.joints:
        raise Missing("no algorithm of it")
    sources = [HERE / "pinocchio.cpp", contenders.CHAIN / "model.cpp", contenders.CHAIN / "spatial.cpp"]
    return {"sources": list(map(str, sources)), "flags": list(map(str, contenders.PINOCCHIO))}


def generated(problem, name):
    """Raises Missing, with the reason."""
    if name in PEERS and name not in contenders.installed():
        raise Missing("not available here")
    if name in PEERS and problem.only and name not in problem.only:
        raise Missing(problem.why)
    maker = {"CasADi": by_python, "SymForce": by_python, "CppADCodeGen": cppadcodegen, "Pinocchio": pinocchio}.get(name, symreal)
    files = [HERE / other for other in ("problems.py", "formulas.py", "differentiate.py", "makers.py", "record.cpp")]
    files += [contenders.HERE / "chain.py", *(source for source in problem.sources)]
    tool = contenders.pathlib.Path(contenders.SYMREAL).stat() if maker is symreal else None
    key = digest(problem.name, name, (tool.st_mtime_ns, tool.st_size) if tool else contenders.installed()[name],
                 *(path.read_text() for path in files))

    def make():
        try:
            return maker(problem, name, folder(problem, name))
        except SystemExit as failure:
            if maker is symreal:
                raise
            print(failure, flush=True)
            raise Missing("its generator fails") from None
    return remembered(key, make)
