"""Lets a peer that is a Python package generate code for a kernel of chain.py, in a process of its own:

     generate.py PEER KERNEL JOINTS DIRECTORY

Writes the code and the contender around it into the directory. Prints what it took as JSON: seconds to evaluate chain.py
on the peer's symbols (record), seconds to optimise and write, and the growth of the most memory meanwhile, in bytes.
"""
import json
import pathlib
import re
import resource
import sys
import time

import chain

# kernel: the method of Chain, and how many vectors it takes
KERNELS = {
    "fk": ("forward_kinematics", 1),
    "rnea": ("inverse_dynamics", 3),
    "crba": ("mass_matrix", 1),
    "aba": ("forward_dynamics", 3),
}
MAKE = """#include "contender.h"
{code}
{prepare}
Evaluate contender(char const *kernel, int joints, char const *model) {{
  (void)kernel, (void)joints, (void)model;
  return evaluate;
}}
"""


def outputs(kernel, joints, module, vectors):
    return getattr(chain.Chain(joints, module.sin, module.cos), KERNELS[kernel][0])(*vectors)


def casadi(kernel, joints, work, clock):
    import casadi

    clock.start()
    inputs = [casadi.SX.sym(f"x{i}", joints) for i in range(KERNELS[kernel][1])]
    result = casadi.vertcat(*outputs(kernel, joints, casadi, map(casadi.vertsplit, inputs)))
    clock.recorded()
    function = casadi.Function("code", inputs, [casadi.cse(result)])
    generator = casadi.CodeGenerator("code.c")
    generator.add(function)
    text = generator.dump()
    clock.written()
    arguments = ", ".join(f"x + {i * joints}" for i in range(len(inputs)))
    adapter = (f"static double work[{function.sz_w() + 1}];\nstatic void evaluate(double const *x, double *y) {{\n"
               f"  double const *arguments[{function.sz_arg() + 1}] = {{{arguments}}};\n  double *results[{function.sz_res() + 1}] = {{y}};\n"
               "  casadi_f0(arguments, results, 0, work, 0);\n}\n")
    (work / "contender.c").write_text(MAKE.format(code=text, prepare=adapter))
    return re.search(r"^static int casadi_f0\(.*?^}", text, re.MULTILINE | re.DOTALL)[0]


def symforce(kernel, joints, work, clock):
    import symforce

    symforce.set_epsilon_to_number()
    import symforce.symbolic as sf
    from symforce.codegen import Codegen, CppConfig
    from symforce.values import Values

    clock.start()
    inputs = [sf.M(joints, 1).symbolic(f"x{i}") for i in range(KERNELS[kernel][1])]
    result = sf.M(outputs(kernel, joints, sf, [[x[i] for i in range(joints)] for x in inputs]))
    clock.recorded()
    codegen = Codegen(inputs=Values(**{f"x{i}": x for i, x in enumerate(inputs)}), outputs=Values(y=result),
                      config=CppConfig(), name="code")
    text = codegen.generate_function(output_dir=work / "symforce").generated_files[0].read_text()
    clock.written()
    vector = f"Eigen::Matrix<double, {joints}, 1>"
    arguments = "".join(f"*reinterpret_cast<{vector} const *>(x + {i * joints}), " for i in range(len(inputs)))
    adapter = (f"static void evaluate(double const *x, double *y) {{\n  sym::Code<double>({arguments}"
               f"reinterpret_cast<Eigen::Matrix<double, {len(result)}, 1> *>(y));\n}}\n")
    (work / "contender.cpp").write_text(MAKE.format(code=text.replace("#pragma once", ""), prepare=adapter))
    return text


SPANS = """#include <cmath>
#include <utility>
namespace wf { // what wrenfold's runtime header has, for contiguous vectors
template <class T> struct Span { T *first; T &operator()(int row, int) const { return first[row]; } };
template <int, int> Span<double const> make_input_span(double const *x) { return {x}; }
template <int, int> Span<double> make_output_span(double *x) { return {x}; }
} // namespace wf
"""


def wrenfold(kernel, joints, work, clock):
    from typing import Annotated

    from wrenfold import code_generation, sym
    from wrenfold.type_annotations import Shape

    Vector = Annotated[sym.MatrixExpr, Shape(rows=joints, cols=1)]
    clock.start()

    def function(*inputs):
        values = [[x[i] for i in range(joints)] for x in inputs]
        result = [code_generation.OutputArg(sym.vector(*outputs(kernel, joints, sym, values)), "y")]
        clock.recorded()
        return result

    def one(a: Vector):
        return function(a)

    def three(a: Vector, b: Vector, c: Vector):
        return function(a, b, c)

    text = code_generation.generate_function(one if KERNELS[kernel][1] == 1 else three, code_generation.CppGenerator())
    clock.written()
    name = "one" if KERNELS[kernel][1] == 1 else "three"
    arguments = "".join(f"x + {i * joints}, " for i in range(KERNELS[kernel][1]))
    adapter = f"static void evaluate(double const *x, double *y) {{ {name}<double>({arguments}y); }}\n"
    (work / "contender.cpp").write_text(MAKE.format(code=SPANS + text, prepare=adapter))
    return text


def memory():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


class Clock:
    def start(self):
        self.times, self.memory = [time.perf_counter()], memory()

    def recorded(self):
        self.times.append(time.perf_counter())
        self.peak = memory() - self.memory

    written = recorded


def operations(text):
    """The operators + - * / in the text of a function, signs aside. A square that is written as a power is one."""
    text = re.sub(r"//.*|/\*.*?\*/|^\s*#.*|\[[^\]]*\]|static_cast<Scalar>", "", text, flags=re.MULTILINE)
    text = re.sub(r"(\d)[eE][-+](\d)", r"\1e\2", text)
    body = text.partition("{")[2]
    squares = len(re.findall(r"pow\([^,]*, *Scalar\(2\)\)", body))
    if squares != body.count("pow("):
        raise SystemExit("bench: a power that is no square")
    return len(re.findall(r"[\w)\]]\s*[-+*/](?!=)", body)) + squares


def main():
    peer, kernel, joints, directory = sys.argv[1:]
    clock = Clock()
    text = {"casadi": casadi, "symforce": symforce, "wrenfold": wrenfold}[peer](kernel, int(joints), pathlib.Path(directory), clock)
    begin, recorded, written = clock.times
    print(json.dumps({"operations": operations(text), "record": recorded - begin, "write": written - recorded, "memory": clock.peak}))


if __name__ == "__main__":
    main()
