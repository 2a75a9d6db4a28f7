"""The kernels that are measured, and how each original is called.

A function kernel is called from a loop that is put into a file of its own (`declare`, `setup`, `call`), with the example
program's main renamed. A region kernel is a stretch of its program's main: `replace` turns its pragmas into the beginning
and the end of a loop, in a copy of the source.
"""
from dataclasses import dataclass, field


@dataclass
class Kernel:
    name: str
    source: str
    others: list = field(default_factory=list)
    flags: list = field(default_factory=list)  # for every compiler of the sources
    options: list = field(default_factory=list)  # for symreal
    kernel: str = ""  # where a source has several
    declare: str = ""
    setup: str = ""
    call: str = ""
    replace: dict = field(default_factory=dict)

    @property
    def directory(self):
        return self.source.rsplit("/", 1)[0]


def chain(name, signature, call, parameters=False):
    setup = ("auto const links = chain::example_model(0, nullptr).links();" if parameters else
             "chain::Model const model = chain::example_model(0, nullptr);")
    return Kernel(
        "chain " + name, f"inputs/chain/{name}.cpp",
        [f"inputs/chain/{other}.cpp" for other in ("algorithms", "example", "model", "spatial")],
        declare='#include "example.h"\n' + signature, setup=setup, call=call)


def dh(name, declare, call, source=None, setup=""):
    return Kernel("dh " + name, f"inputs/dh/{source or name}.cpp", ["inputs/dh/dynamics.cpp", "inputs/dh/robot.cpp"],
                  kernel=name if source else "", declare=declare, setup=setup, call=call)


MODEL = "chain::Model const &model, double const *"
LINKS = "chain::Link const *, int, double const *, double const *"
AGAIN = "bench_again:; double *in = bench_next();"

KERNELS = [
    Kernel("rotation", "inputs/rotation/rotation.cpp", replace={
        "#pragma symreal input": AGAIN + " q = in[0];",
        "#pragma symreal output": "for (int i = 0; i < 3; i++) bench_output[i] = c[i][0]; goto bench_again;"}),
    Kernel("rotation_full", "inputs/rotation/rotation_full.cpp",
           declare="void rotated(double q, double c[3][3]);", call="rotated(in[0], (double(*)[3])bench_output);"),
    chain("fk", f"void fk({MODEL}, double *);", "fk(model, in, bench_output);"),
    chain("rnea", f"void rnea({MODEL}, double const *, double const *, double *);",
          "rnea(model, in, in + 6, in + 12, bench_output);"),
    chain("crba", f"void crba({MODEL}, double *);", "crba(model, in, bench_output);"),
    chain("aba", f"void aba({MODEL}, double const *, double const *, double *);",
          "aba(model, in, in + 6, in + 12, bench_output);"),
    chain("rnea_parameters", f"void rnea({LINKS}, double const *, double const *, double *);",
          "rnea(links.data(), 6, bench_parameters, in, in + 6, in + 12, bench_output);", True),
    chain("crba_parameters", f"void crba({LINKS}, double *);",
          "crba(links.data(), 6, bench_parameters, in, bench_output);", True),
    chain("aba_parameters", f"void aba({LINKS}, double const *, double const *, double *);",
          "aba(links.data(), 6, bench_parameters, in, in + 6, in + 12, bench_output);", True),
    dh("rx90_inverse", "void rx90_inverse(double const *, double const *, double const *, double const *, double *);",
       "rx90_inverse(bench_parameters, in, in + 6, in + 12, bench_output);"),
    dh("rx90_mass", "void rx90_mass(double const *, double const *, double (*)[6]);",
       "rx90_mass(bench_parameters, in, (double(*)[6])bench_output);"),
    dh("rx90_forward", "void rx90_forward(double const *, double const *, double const *, double const *, double *);",
       "rx90_forward(bench_parameters, in, in + 6, in + 12, bench_output);"),
    dh("planar_inverse",
       "void planar_inverse(int, double const *, double const *, double const *, double const *, double *);",
       "planar_inverse(3, bench_parameters, in, in + 3, in + 6, bench_output);", "planar"),
    dh("planar_forward",
       "void planar_forward(int, double const *, double const *, double const *, double const *, double *);",
       "planar_forward(3, bench_parameters, in, in + 3, in + 6, bench_output);", "planar"),
    Kernel("pendulum_c89", "inputs/pendulum_c89/pendulum.c", options=["--link", "-lm"],
           declare='extern "C" { extern double state[4]; void step(double t, double h); }',
           setup="bench_result = state;", call="memcpy(state, in, sizeof state); step(in[4], bench_parameters[8]);"),
    Kernel("arm_eigen", "inputs/arm_eigen/arm.cpp", flags=["-I/usr/include/eigen3"], replace={
        "#pragma symreal input": AGAIN + " for (int i = 0; i < 7; i++) q[i] = in[i];"
                                         " for (int i = 0; i < 3; i++) velocity[i] = in[7 + i];",
        "#pragma symreal output": "for (int i = 0; i < 7; i++) bench_output[i] = qd[i];"
                                  " for (int i = 0; i < 3; i++) bench_output[7 + i] = position[i];"
                                  " bench_output[10] = manipulability; goto bench_again;"}),
    Kernel("kalman", "inputs/kalman/kalman.cpp",
           declare="void filter_step(double *, double (*)[5], double const *, double const *);",
           setup="bench_result = bench_scratch;",
           call="filter_step(in, (double(*)[5])(in + 5), in + 30, bench_parameters);"),
    Kernel("kdl_fk", "inputs/kdl_fk/kdl_fk.cpp", options=["--root", "inputs/kdl_fk", "--root", "/usr/include/kdl"],
           declare='#include <kdl/frames.hpp>\nvoid forward_kinematics(double const *, KDL::Frame &);',
           setup="static KDL::Frame pose;",
           call="forward_kinematics(in, pose); memcpy(bench_output, pose.M.data, 72);"
                " memcpy(bench_output + 9, pose.p.data, 24);"),
]
