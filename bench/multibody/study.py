"""The large-scale study: see bench/study.

   families     generate ──▶ compile ──▶ equal outputs ──▶ times in turns; parallelism; growth
   simulations  trajectories by original and generated code, equal to the last bit
   plots        operations at once, of a few members
   largest      the analysis of a graph of more than ten million operations
   real         a kernel of a well-known library
"""
import json
import os
import pathlib
import sys

import families
import kernels
import measure
import page
import parallelism
import simulations

WORK = pathlib.Path("build/study")


def run_families():
    load = os.getloadavg()[1]
    results = families.measure_families(families.SHAPES, WORK, rounds=9)
    growth = {f"{kernel} {shape}": families.growth(kernel, shape)
              for shape in ("planar", "spatial", "binary") for kernel in families.KERNELS}
    return {"members": results, "growth": growth, "machine": measure.machine(), "load": load}


def run_simulations():
    return {"models": simulations.measure_simulations(simulations.SIMULATED, WORK, rounds=9), "machine": measure.machine()}


def run_plots():
    return parallelism.draw(page.DOCS, WORK)


def run_largest():
    return parallelism.largest(WORK)


def run_real():
    """Forward kinematics on the headers of Orocos KDL, as bench/run measures it."""
    measure.WORK.mkdir(parents=True, exist_ok=True)
    return measure.measure(next(kernel for kernel in kernels.KERNELS if kernel.name == "kdl_fk"))


def small(work):
    families.measure_families(families.SMALL, work, rounds=3)
    simulations.measure_simulations(["slider_crank"], work, rounds=2)


PARTS = {"families": run_families, "simulations": run_simulations, "plots": run_plots, "largest": run_largest, "real": run_real}


def main():
    wanted = sys.argv[1:] or list(PARTS)
    if wanted[0] == "--small":
        return small(pathlib.Path(wanted[1]) if len(wanted) > 1 else WORK / "small")
    if wanted == ["--page"]:
        wanted = []
    if unknown := [part for part in wanted if part not in PARTS]:
        sys.exit(f"study: there is no part {unknown[0]}; there are {', '.join(PARTS)}")
    WORK.mkdir(parents=True, exist_ok=True)
    for part in wanted:
        (WORK / f"{part}.json").write_text(json.dumps(PARTS[part](), indent=1))
    if missing := [part for part in PARTS if not (WORK / f"{part}.json").exists()]:
        return print(f"study: no page yet, for want of {', '.join(missing)}")
    page.write({part: json.loads((WORK / f"{part}.json").read_text()) for part in PARTS})


main()
