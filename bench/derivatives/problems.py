"""What is differentiated: the sources that Symreal and CppADCodeGen read, the formulas that the others get, and the request.

A model has the inputs x and z, one behind the other, and the outputs y. Derivatives are by x.
"""
import math
import pathlib
import random
from dataclasses import dataclass, field

import formulas

VECTORS = 16
LENGTHS = [1, 2, 4, 8, 16, 32, 64]
MODELS, INPUTS = pathlib.Path("bench/derivatives/models"), pathlib.Path("inputs")
DH = [INPUTS / "dh/dynamics.cpp", INPUTS / "dh/robot.cpp"]


@dataclass
class Problem:
    name: str
    title: str
    formulas: object
    counts: tuple  # of x, z and y
    sources: list = field(default_factory=list)
    derivative: str = "jacobian"  # gradient, hessian
    joints: int = 0  # of the chain, whose sources are programs
    near: list = field(default_factory=list)  # x and z about which vectors are drawn
    spread: float = 0.3
    flags: list = field(default_factory=list)
    options: list = field(default_factory=list)  # for symreal
    only: tuple = ()  # the peers that can express it
    why: str = ""  # the others cannot

    @property
    def outputs(self):
        x, _, y = self.counts
        return y + (x * x if self.derivative == "hessian" else x * y)

    def vectors(self):
        """Always the same."""
        draw = random.Random(self.name).uniform
        return [[value + self.spread * draw(-1, 1) * max(abs(value), 0.1) for value in self.near] for _ in range(VECTORS)]


def chain(kernel, joints):
    title, method = {"rnea": ("inverse", "inverse_dynamics"), "aba": ("forward", "forward_dynamics")}[kernel]
    draw = random.Random(joints).uniform
    near = [draw(-3, 3) for _ in range(joints)] + [draw(-1, 1) for _ in range(2 * joints)]
    return Problem(f"{kernel}-{joints}", f"{title} dynamics, N = {joints}", formulas.of_chain(method, joints), (2 * joints, joints, joints),
                   [INPUTS / f"chain/{name}.cpp" for name in (kernel, "algorithms", "example", "model", "spatial")], joints=joints, near=near)


def mixture(name, title, components, points, derivative):
    draw = random.Random(name).uniform
    near = [draw(-1, 1) for _ in range(6 * components + 2 * points)]
    return Problem(name, title, formulas.mixture(components, points), (6 * components, 2 * points, 1), [MODELS / "mixture.cpp"], derivative,
                   near=near, flags=[f"-DCOMPONENTS={components}", f"-DPOINTS={points}"])


ARM = [0.3, 0.5, 0.7, 0.9, 1.1, 1.3, 0.5, 0.4, 0.3, 0.2, 0.1, -0.1, -0.4, -0.1, 0.2, 0.5, 0.8, 1.1]
COVARIANCE = [(0.25, 0.25, 0.01, 0.16, 0.0025)[i] if i == j else 0.001 for i in range(5) for j in range(5)]
PROBLEMS = [chain(kernel, joints) for kernel in ("rnea", "aba") for joints in sorted([*LENGTHS, 6])] + [
    Problem("rx90", "RX90, inverse dynamics", formulas.rx90, (12, 6, 6), [MODELS / "rx90.cpp", *DH], near=ARM),
    Problem("rx90-forward", "RX90, forward dynamics", formulas.rx90_forward, (12, 6, 6), [MODELS / "rx90_forward.cpp", *DH], near=ARM),
    Problem("quadrotor", "quadrotor", formulas.quadrotor, (17, 1, 13), [MODELS / "quadrotor.cpp"],
            near=[1, 2, 3, 0.9, 0.1, -0.2, 0.3, 1, -0.5, 0.2, 0.1, 0.3, -0.2, 590, 600, 610, 580, 0.85]),
    Problem("vehicle", "vehicle, with tables and limits", formulas.vehicle, (7, 2, 5), [MODELS / "vehicle.cpp", INPUTS / "vehicle/vehicle.cpp"],
            near=[150.0, 0.08, 0.01, 0.1, 4000.0, 0.4, -0.03, 9300.0, 75000.0], options=["--decisions=select"],
            only=("CasADi",), why="no tables, or no branch on a number that is recorded"),
    Problem("kalman", "Kalman filter, by the state", formulas.kalman, (5, 27, 30), [MODELS / "kalman.cpp", INPUTS / "kalman/kalman.cpp"],
            near=[0.2, 0.1, 0.3, 4.0, 0.2, *COVARIANCE, 20.3, -0.52], spread=0.1),
    Problem("bundle", "bundle adjustment", formulas.bundle, (15, 2, 3), [MODELS / "bundle.cpp"],
            near=[0.1, -0.2, 0.15, 0.3, 0.5, -4.0, 500.0, 320.0, 240.0, -0.1, 0.02, 0.5, -0.4, 1.0, 0.9, 370.0, 200.0]),
    mixture("mixture", "Gaussian mixture, gradient", 5, 10, "gradient"),
    mixture("mixture-hessian", "Gaussian mixture, Hessian", 3, 5, "hessian"),
]
assert all(len(each.near) == sum(each.counts[:2]) and all(map(math.isfinite, each.near)) for each in PROBLEMS)
