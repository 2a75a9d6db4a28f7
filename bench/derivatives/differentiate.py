"""Lets a peer that is a Python package differentiate a problem and generate code, in a process of its own:

     differentiate.py PEER PROBLEM DIRECTORY

Writes the contender into the directory; prints operations and seconds as JSON.
"""
import json
import pathlib
import re
import sys
import time
import types

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "peers"))
from generate import MAKE  # noqa: E402
from problems import PROBLEMS  # noqa: E402


def operations(text):
    """The operators + - * / in a function, signs aside, and squares; other powers are calls, as sines."""
    text = re.sub(r"//.*|/\*.*?\*/|^\s*#.*|\[[^\]]*\]|static_cast<Scalar>", "", text, flags=re.MULTILINE)
    text = re.sub(r"(\d)[eE][-+](\d)", r"\1e\2", re.sub(r"Scalar\(\d+\)\s*/\s*Scalar\(\d+\)", "1", text))
    body = text.partition("{")[2]
    squares = len(re.findall(r"pow\([^,]*, *(?:Scalar\(2\)|2\.?0*)\)|casadi_sq\(", body))
    return len(re.findall(r"[\w)\].]\s*[-+*/](?!=)", body)) + len(re.findall(r"[-+*/]=", body)) + squares


def casadi(problem, work):
    import casadi

    begin = time.perf_counter()
    x, z = (casadi.SX.sym(name, count) for name, count in zip("xz", problem.counts))
    y = casadi.vertcat(*problem.formulas(casadi.vertsplit(x), casadi.vertsplit(z), casadi))
    derivative = casadi.hessian(y, x)[0] if problem.derivative == "hessian" else casadi.jacobian(y, x)
    whole = casadi.vertcat(y, casadi.vec(casadi.densify(derivative.T)))
    function = casadi.Function("code", [x, z], [casadi.cse(whole)])
    generator = casadi.CodeGenerator("code.c")
    generator.add(function)
    text = generator.dump()
    took = time.perf_counter() - begin
    adapter = (f"static double work[{function.sz_w() + 1}];\nstatic void evaluate(double const *x, double *y) {{\n"
               f"  double const *arguments[{function.sz_arg() + 1}] = {{x, x + {problem.counts[0]}}};\n"
               f"  double *results[{function.sz_res() + 1}] = {{y}};\n  casadi_f0(arguments, results, 0, work, 0);\n}}\n")
    (work / "contender.c").write_text(MAKE.format(code=text, prepare=adapter))
    return re.search(r"^static int casadi_f0\(.*?^}", text, re.MULTILINE | re.DOTALL)[0], took


def symforce(problem, work):
    import symforce

    symforce.set_epsilon_to_number()
    import symforce.symbolic as sf
    from symforce.codegen import Codegen, CppConfig
    from symforce.values import Values

    module = types.SimpleNamespace(**{name: getattr(sf, name) for name in ("sin", "cos", "sqrt", "exp", "log")},
                                   atan2=lambda y, x: sf.atan2(y, x, epsilon=0), fmax=sf.Max)
    begin = time.perf_counter()
    x, z = (sf.M(count, 1).symbolic(name) for name, count in zip("xz", problem.counts))
    y = sf.M(problem.formulas(*([vector[i] for i in range(len(vector))] for vector in (x, z)), module))
    derivative = y.jacobian(x)
    if problem.derivative == "hessian":
        derivative = sf.M(list(derivative)).jacobian(x)
    whole = sf.M([*y, *(derivative[i, j] for i in range(derivative.shape[0]) for j in range(derivative.shape[1]))])
    codegen = Codegen(inputs=Values(x=x, z=z), outputs=Values(y=whole), config=CppConfig(), name="code")
    text = codegen.generate_function(output_dir=work / "symforce").generated_files[0].read_text()
    took = time.perf_counter() - begin

    def vector(count):
        return f"Eigen::Matrix<double, {count}, 1>"

    inputs = (f"*reinterpret_cast<{vector(problem.counts[0])} const *>(x), "
              f"*reinterpret_cast<{vector(problem.counts[1])} const *>(x + {problem.counts[0]})")
    adapter = (f"static void evaluate(double const *x, double *y) {{\n  sym::Code<double>({inputs}, "
               f"reinterpret_cast<{vector(problem.outputs)} *>(y));\n}}\n")
    (work / "contender.cpp").write_text(MAKE.format(code=text.replace("#pragma once", ""), prepare=adapter))
    return text, took


def main():
    peer, name, directory = sys.argv[1:]
    problem = next(each for each in PROBLEMS if each.name == name)
    text, took = {"CasADi": casadi, "SymForce": symforce}[peer](problem, pathlib.Path(directory))
    print(json.dumps({"operations": operations(text), "generate": took}))


if __name__ == "__main__":
    main()
