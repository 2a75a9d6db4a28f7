"""Trajectories by the original and by generated code: see simulate.cpp and models/."""
import json
import math
from dataclasses import dataclass, field

import contenders
import measure
from families import MODELS

TREE = [MODELS / "tree.cpp", MODELS / "dynamics.cpp"]


@dataclass
class Model:
    title: str
    source: str
    states: int
    step: float
    steps: int
    others: list = field(default_factory=list)
    options: list = field(default_factory=list)
    flags: list = field(default_factory=list)


def motion(title, shape, n, step, steps):
    return Model(title, "motion", 2 * n, step, steps, TREE, ["--root", "inputs/dh"],
                 [f'-DSHAPE="{shape}"', f"-DN={n}", "-Iinputs/dh"])


SIMULATED = {
    "double_pendulum": Model("double pendulum", "double_pendulum", 4, 1e-3, 20000),
    "slider_crank": Model("slider-crank, 3 bodies, 8 constraints", "slider_crank", 18, 1e-4, 20000),
    "four_bar": Model("four-bar, 3 bodies, 8 constraints", "four_bar", 18, 1e-4, 20000),
    "andrews": Model("Andrews' squeezing mechanism, 7 bodies, 6 constraints", "andrews", 14, 1e-6, 30000),
    "aircraft": Model("aircraft, longitudinal, with tables and limits", "aircraft", 5, 1e-3, 20000,
                      options=["--root", "inputs/vehicle", "--decisions=select"], flags=["-Iinputs/vehicle"]),
    "spatial_6": motion("spatial chain of 6 bodies", "spatial", 6, 1e-3, 5000),
    "planar_32": motion("planar chain of 32 bodies", "planar", 32, 1e-3, 1000),
    "binary_15": motion("binary tree of 15 bodies", "binary", 15, 1e-3, 2000),
    "humanoid": motion("humanoid of 30 bodies", "humanoid", 30, 1e-3, 1000),
}
# The angles and their rates at t = 0.03 of the Test Set for IVP Solvers (andrews.f, revision 1.2), computed there with PSIDE to a
# tolerance of 1e-14.
ANDREWS = [15.81077119629904, -15.75637105984298, 0.04082224013073101, -0.5347301163226948, 0.5244099658805304,
           0.5347301163226948, 1.048080741042263, 1139.920302151208, -1424.379294994111, 11.03291221937134,
           19.29337464421385, 0.5735699284790808, -19.29337464421385, 0.3231791658026955]


def generate(model, work):
    words = [measure.SYMREAL, "generate", MODELS / f"{model.source}.cpp", *model.others, *model.options, "--kernel", "rates",
             "-o", work / "kernel.c", "--json"]
    return json.loads(measure.command(words + (["--", *model.flags] if model.flags else [])))["kernels"][0]


def build(model, work):
    """Every contender has the same driver and initial state; the compiler may contract neither."""
    common = [f"-I{MODELS}", *model.flags]
    driver = [*common, f"-DSTATES={model.states}", f"-DSTEPS={model.steps}", f"-DSTEP={model.step}", "-O2", "-ffp-contract=off"]
    header = f'-DBENCH_HEADER="{(work / "kernel.h").resolve()}"'
    jobs = [("bench/multibody/simulate.cpp", work / "original.o", driver),
            ("bench/multibody/simulate.cpp", work / "generated.o", [*driver, header])]
    parts = {}
    for name, flags in contenders.ORIGINALS.items():
        parts[name] = [work / "original.o"]
        for source in [MODELS / f"{model.source}.cpp", *model.others]:
            target = work / f"{name} {source.stem}.o".replace(" ", "_")
            jobs.append((source, target, [*common, *flags, "-Dmain=example_main"]))
            parts[name].append(target)
    for name, flags in contenders.GENERATED.items():
        target = work / f"{name}.o".replace(" ", "_")
        jobs.append((work / "kernel.c", target, flags))
        parts[name] = [work / "generated.o", target, *parts["reference"][1:]]
    contenders.compile_all(jobs)
    executables = {name: work / name.replace(" ", "_") for name in parts}
    for name, objects in parts.items():
        measure.command(["g++", "-o", executables[name], *objects, "-lm"])
    return executables


def agreeing_digits(values, reference):
    worst = max(abs(value - expected) / abs(expected) for value, expected in zip(values, reference))
    return -math.log10(worst)


def simulate(name, top, rounds):
    model, work = SIMULATED[name], top / name
    work.mkdir(parents=True, exist_ok=True)
    report = generate(model, work)
    executables = build(model, work)
    every = max(1, model.steps // 1000)
    trajectories = {contender: measure.command([path, every]) for contender, path in executables.items()}
    reference = trajectories["reference"]
    for contender in contenders.GENERATED:
        if trajectories[contender] != reference:
            raise SystemExit(f"study: {name}: {contender} leaves the original's trajectory")
    end = [float.fromhex(word) for word in reference.splitlines()[-1].split()]
    if not all(map(math.isfinite, end)):
        raise SystemExit(f"study: {name}: the original's trajectory is not finite")
    times = {contender: [] for contender in executables}
    for _ in range(rounds):
        for contender, path in executables.items():
            times[contender].append(float(measure.command(["nice", "-n", "-5", path])))
    result = {"name": name, "title": model.title, "states": model.states, "step": model.step, "steps": model.steps,
              "compared": len(reference.splitlines()), "end": end,
              "operations": {stage: measure.counts(report["operations"][stage]) for stage in ("executed", "compute")},
              "nanoseconds": {contender: contenders.spread(values, min(values)) for contender, values in times.items()},
              "speedup": contenders.gains(times)}
    if name == "andrews":
        result["digits"] = [agreeing_digits(end[part], ANDREWS[part]) for part in (slice(0, 7), slice(7, 14))]
        if result["digits"][0] < 9 or result["digits"][1] < 7:
            raise SystemExit(f"study: andrews: only {result['digits']} digits of the published solution")
    return result


def measure_simulations(names, top, rounds):
    results = []
    for name in names:
        results.append(simulate(name, top, rounds))
        last = results[-1]
        said = ", ".join(f"{contender} {ratio['quickest']:.2f}x" for contender, ratio in last["speedup"].items())
        digits = ", {:.0f} and {:.0f} digits of the published solution".format(*map(math.floor, last["digits"])) if "digits" in last else ""
        print(f"{name}: {last['operations']['executed']['arithmetic']} operations -> {last['operations']['compute']['arithmetic']}, "
              f"{last['compared']} states of {last['steps']} steps equal to the last bit{digits}; {said}", flush=True)
    return results
