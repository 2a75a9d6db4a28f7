"""Operations in the code that each generator writes for the six-joint chain: see bench/peers/run.

The peers get chain.py, Symreal the C++ sources in inputs/chain. Every file is counted by the same means: the operators
+ - * / in the text of the function, signs aside. A square that is written as a power is one multiplication.
"""
import csv
import importlib.metadata
import math
import os
import pathlib
import re
import subprocess
import tempfile

import chain

JOINTS = 6
# what it is called: the method of Chain, how many vectors it takes, its name in inputs/chain
KERNELS = {
    "forward kinematics": ("forward_kinematics", 1, "fk"),
    "inverse dynamics": ("inverse_dynamics", 3, "rnea"),
    "mass matrix": ("mass_matrix", 1, "crba"),
    "forward dynamics": ("forward_dynamics", 3, "aba"),
}


def outputs(method, module, vectors):
    return getattr(chain.Chain(JOINTS, module.sin, module.cos), method)(*vectors)


def casadi_code(method, vectors, work):
    import casadi

    inputs = [casadi.SX.sym(f"x{i}", JOINTS) for i in range(vectors)]
    result = casadi.vertcat(*outputs(method, casadi, map(casadi.vertsplit, inputs)))
    generator = casadi.CodeGenerator("code.c")
    generator.add(casadi.Function("code", inputs, [casadi.cse(result)]))
    return re.search(r"^static int casadi_f0\(.*?^}", generator.dump(), re.MULTILINE | re.DOTALL)[0]


def symforce_code(method, vectors, work):
    import symforce

    symforce.set_epsilon_to_number()
    import symforce.symbolic as sf
    from symforce.codegen import Codegen, CppConfig
    from symforce.values import Values

    inputs = [sf.M(JOINTS, 1).symbolic(f"x{i}") for i in range(vectors)]
    result = sf.M(outputs(method, sf, [[x[i] for i in range(JOINTS)] for x in inputs]))
    codegen = Codegen(inputs=Values(**{f"x{i}": x for i, x in enumerate(inputs)}), outputs=Values(y=result),
                      config=CppConfig(), name="code")
    return codegen.generate_function(output_dir=work).generated_files[0].read_text()


def wrenfold_code(method, vectors, work):
    from wrenfold import code_generation, sym
    from wrenfold.type_annotations import Vector6

    def function(*inputs):
        values = [[x[i] for i in range(JOINTS)] for x in inputs]
        return [code_generation.OutputArg(sym.vector(*outputs(method, sym, values)), "y")]

    def one(a: Vector6):
        return function(a)

    def three(a: Vector6, b: Vector6, c: Vector6):
        return function(a, b, c)

    return code_generation.generate_function(one if vectors == 1 else three, code_generation.CppGenerator())


def symreal_code(name, work):
    sources = [f"inputs/chain/{source}.cpp" for source in (name, "algorithms", "example", "model", "spatial")]
    code = work / f"{name}.c"
    subprocess.run([os.environ["SYMREAL"], "generate", *sources, "-o", code], check=True, capture_output=True)
    return re.search(r"^void compute\(.*?^}", code.read_text(), re.MULTILINE | re.DOTALL)[0]


def operations(text):
    text = re.sub(r"//.*|/\*.*?\*/|^\s*#.*|\[[^\]]*\]|static_cast<Scalar>", "", text, flags=re.MULTILINE)
    text = re.sub(r"(\d)[eE][-+](\d)", r"\1e\2", text)
    signature, _, body = text.partition("{")
    squares = len(re.findall(r"pow\([^,]*, *Scalar\(2\)\)", body))
    if squares != body.count("pow("):
        raise SystemExit("bench: a power that is no square")
    return len(re.findall(r"[\w)\]]\s*[-+*/](?!=)", body)) + squares


def check_chain():
    """chain.py computes what inputs/chain computes."""
    def sequence(first, step):
        return [first + step * i for i in range(JOINTS)]

    vectors = [sequence(0.3, 0.2), sequence(0.5, -0.1), sequence(-0.4, 0.3)]
    computed = {name: outputs(method, math, vectors[:count]) for method, count, name in KERNELS.values()}
    with open(chain.DATA / "chain-reference.csv") as file:
        rows = [row for row in csv.DictReader(file) if int(row["N"]) == JOINTS]
    wrong = [row for row in rows
             if abs(computed[row["algorithm"].lower()][int(row["output"])] - float(row["value"])) > 1e-11]
    if wrong or not rows:
        raise SystemExit(f"bench: chain.py is wrong: {wrong}")


def main():
    check_chain()
    peers = {"CasADi": casadi_code, "SymForce": symforce_code, "wrenfold": wrenfold_code}
    versions = {name: importlib.metadata.version(name.lower()) for name in peers}
    lines = ["| Six-joint chain | Symreal | " + " | ".join(f"{name} {versions[name]}" for name in peers) + " |",
             "|---" * (len(peers) + 2) + "|"]
    for title, (method, vectors, name) in KERNELS.items():
        with tempfile.TemporaryDirectory() as directory:
            work = pathlib.Path(directory)
            counts = [operations(symreal_code(name, work))]
            counts += [operations(code(method, vectors, work / peer)) for peer, code in peers.items()]
        lines.append(f"| {title} | " + " | ".join(map(str, counts)) + " |")
        print(lines[-1], flush=True)
    written = len(pathlib.Path(chain.__file__).read_text().splitlines())
    pathlib.Path("bench/peers/results.md").write_text(f"""# Operations left by other generators

Written by `bench/peers/run`. The numbers are the operators + - * / in the code that each tool generates; signs, sines and
cosines are not counted.

{chr(10).join(lines)}

All four algorithms are those of [inputs/chain](../../inputs/chain): textbook formulas with full 6x6 matrices. Symreal reads
these C++ sources; each function has one pragma. The other tools take no C++ program, so [chain.py](chain.py) writes the
library again, {written} lines, with the operations in the same order. The script checks its results against
[chain-reference.csv](../../inputs/chain/data/chain-reference.csv) before it counts.

Symreal works in its default mode `finite`, which keeps every result equal to the original's and therefore regroups no sum
and no product. The other tools promise no such thing: SymForce regroups both, and needs the fewest operations for three of
the four.
""")


main()
